// SPDX-License-Identifier: GPL-2.0-or-later
// Reads quantities such as "3 kPa" or "5e-7 s" into numbers in SI units, and checks their dimension.
#pragma once

#include <string>
#include <string_view>

namespace flowslide {

/// Exponents of kilogram, metre, second and radian. The radian counts as a dimension, so an angle is never read as a
/// ratio.
struct Dimension {
  int kilogram = 0;
  int metre = 0;
  int second = 0;
  int radian = 0;

  friend constexpr bool operator==(const Dimension&, const Dimension&) = default;
};

namespace dimension {
inline constexpr Dimension dimensionless{};
inline constexpr Dimension angle{0, 0, 0, 1};             ///< rad
inline constexpr Dimension mass{1, 0, 0, 0};              ///< kg
inline constexpr Dimension length{0, 1, 0, 0};            ///< m
inline constexpr Dimension time{0, 0, 1, 0};              ///< s
inline constexpr Dimension rate{0, 0, -1, 0};             ///< 1/s, strain rate
inline constexpr Dimension velocity{0, 1, -1, 0};         ///< m/s
inline constexpr Dimension acceleration{0, 1, -2, 0};     ///< m/s^2
inline constexpr Dimension area{0, 2, 0, 0};              ///< m^2
inline constexpr Dimension volume{0, 3, 0, 0};            ///< m^3
inline constexpr Dimension density{1, -3, 0, 0};          ///< kg/m^3
inline constexpr Dimension unit_weight{1, -2, -2, 0};     ///< N/m^3
inline constexpr Dimension force{1, 1, -2, 0};            ///< N
inline constexpr Dimension stress{1, -1, -2, 0};          ///< Pa
inline constexpr Dimension stress_rate{1, -1, -3, 0};     ///< Pa/s
inline constexpr Dimension viscosity{1, -1, -1, 0};       ///< Pa s
inline constexpr Dimension mass_rate{1, 0, -1, 0};        ///< kg/s, drag coefficient
inline constexpr Dimension compressibility{-1, 1, 2, 0};  ///< 1/Pa
inline constexpr Dimension energy{1, 2, -2, 0};           ///< J
}  // namespace dimension

/// The name of a dimension with its article: "a stress", "a number without unit". A dimension that has no name gives
/// "a quantity in kg m^-2".
std::string name_of(const Dimension& dimension);

/// The SI unit of a dimension: "Pa", "kg/s"; "" if dimensionless. A dimension that has no name gives "kg m^-2".
std::string unit_of(const Dimension& dimension);

/// An example of a quantity of this dimension: 3 kPa. The text has no quotes.
std::string example_of(const Dimension& dimension);

/// A number in SI units with its dimension. `has_unit` is false if no unit was written.
struct Quantity {
  double value = 0.0;
  Dimension dimension;
  bool has_unit = false;
};

/// Reads a number and its unit, if any: "3 kPa", "3kPa", "2650 kg/m^3", "1e3 kPa/min", "0.06 1/s", "25 %", "5e-7".
/// A unit is a product of known symbols (kg g t, m cm mm um km, s ms us ns min h d day, Pa kPa MPa GPa, N mN kN, J, Hz,
/// deg rad, %). They are joined by "*", a blank or "/". "/" divides by the next symbol only. Each symbol may have an
/// integer exponent such as "^-2".
/// The conversion multiplies once and divides once, so "7.5 mm" gives the same double as 0.0075.
/// Throws std::invalid_argument if the text is not a quantity. The message gives the text and the problem, and for an
/// unknown unit the nearest known one.
Quantity parse_quantity(std::string_view text);

/// The value of `text` in SI units. Throws std::invalid_argument if the text is not a quantity, has another dimension
/// (the message names both dimensions and gives an example) or lacks its unit (see needs_unit and missing_unit).
double parse_quantity(std::string_view text, const Dimension& expected, std::string_view likely_unit = {});

/// Whether a number of this dimension needs a unit. Zero needs none: it is the same in every unit. Infinity and NaN
/// need none: the check of the range refuses them.
bool needs_unit(double value, const Dimension& dimension);

/// The message about a number without a unit: problem and remedy, such as
///   has no unit: it would be 4 rad = 229.2 deg; write "4 deg" or "4 rad"
/// `number` is the number as written, `value` its value. The remedy names `likely_unit` first; if this is empty, the
/// usual unit of the dimension.
std::string missing_unit(std::string_view number, double value, const Dimension& dimension,
                         std::string_view likely_unit = {});

}  // namespace flowslide

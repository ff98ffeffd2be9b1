// SPDX-License-Identifier: GPL-2.0-or-later
// Quantities as people write them, "3 kPa" or "5e-7 s", turned into SI numbers and checked for dimension.
#pragma once

#include <string>
#include <string_view>

namespace flowslide {

/// Exponents of kilogram, metre, second and radian. The radian is kept apart, so that no angle passes for a ratio.
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
inline constexpr Dimension rate{0, 0, -1, 0};             ///< 1/s, of strain
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
inline constexpr Dimension mass_rate{1, 0, -1, 0};        ///< kg/s, of a drag coefficient
inline constexpr Dimension compressibility{-1, 1, 2, 0};  ///< 1/Pa
inline constexpr Dimension energy{1, 2, -2, 0};           ///< J
}  // namespace dimension

/// A word for a dimension with its article: "a stress", "a number without unit"; for one without a name
/// "a quantity in kg m^-2".
std::string name_of(const Dimension& dimension);

/// The SI unit of a dimension: "Pa", "kg/s", "" when dimensionless; for one without a name "kg m^-2".
std::string unit_of(const Dimension& dimension);

/// A quantity of that dimension as a user could write it, such as "3 kPa" (without the quotes).
std::string example_of(const Dimension& dimension);

/// A number in SI units with its dimension. `has_unit` is false for a bare number.
struct Quantity {
  double value = 0.0;
  Dimension dimension;
  bool has_unit = false;
};

/// Reads a number and its unit, if any: "3 kPa", "3kPa", "2650 kg/m^3", "1e3 kPa/min", "0.06 1/s", "25 %", "5e-7".
/// Units are products of known symbols (kg g t, m cm mm um km, s ms us ns min h d day, Pa kPa MPa GPa, N mN kN, J, Hz,
/// deg rad, %) joined by "*", a blank or "/" (which divides by the next symbol only), each with an integer exponent
/// such as "^-2".
/// Rounds at most twice, so that "7.5 mm" and 0.0075 are the same number.
/// Throws std::invalid_argument: the text, what is wrong with it, and the nearest known unit.
Quantity parse_quantity(std::string_view text);

/// The value of `text` in SI units. Throws std::invalid_argument when the text is no quantity, is of another dimension
/// (the text, the dimension expected with an example, and what was given) or lacks its unit (see needs_unit and
/// missing_unit).
double parse_quantity(std::string_view text, const Dimension& expected, std::string_view likely_unit = {});

/// Whether a bare number is refused as a quantity of this dimension. 0 is the same in every unit; numbers that are not
/// finite are left to the check of the range.
bool needs_unit(double value, const Dimension& dimension);

/// What is wrong with the bare number `number` (as written, of that value) and how to mend it, for a message:
/// `has no unit: it would be 4 rad = 229.2 deg; write "4 deg" or "4 rad"`. `likely_unit` stands first; when empty, the
/// unit that is usual for the dimension.
std::string missing_unit(std::string_view number, double value, const Dimension& dimension,
                         std::string_view likely_unit = {});

}  // namespace flowslide

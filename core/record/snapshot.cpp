// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/snapshot.hpp"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <stdexcept>
#include <type_traits>

#include "record/base64.hpp"
#include "record/gnuplot_table.hpp"

namespace flowslide {
namespace {

static_assert(std::endian::native == std::endian::little, "the files say byte_order=\"LittleEndian\"");

/// A data array in VTK's inline binary format: the number of bytes (UInt64), then the values, all in base64.
template <typename T>
std::string array(const std::string& name, int components, const std::vector<T>& values) {
  const char* type = std::is_same_v<T, float> ? "Float32" : std::is_same_v<T, std::int64_t> ? "Int64" : "UInt8";
  const std::uint64_t size = values.size() * sizeof(T);
  std::string bytes(reinterpret_cast<const char*>(&size), sizeof size);
  bytes.append(reinterpret_cast<const char*>(values.data()), size);
  return fmt::format("<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"binary\">{}</DataArray>\n",
                     type, name, components, base64(bytes));
}

std::vector<float> scaled(const std::vector<double>& values, double factor) {
  std::vector<float> result;
  result.reserve(values.size());
  for (const double value : values) result.push_back(static_cast<float>(factor * value));
  return result;
}

std::vector<float> flat(const std::vector<Vector3>& values) {
  std::vector<float> result;
  for (const Vector3& value : values)
    for (const double component : value) result.push_back(static_cast<float>(component));
  return result;
}

std::vector<std::int64_t> counted(std::size_t n, std::int64_t first, std::int64_t step) {
  std::vector<std::int64_t> result;
  for (std::size_t i = 0; i < n; ++i) result.push_back(first + step * static_cast<std::int64_t>(i));
  return result;
}

/// One piece of PolyData. `cells` is "Verts" or "Lines"; each cell has `per_cell` consecutive points.
std::string poly_data(const std::vector<Vector3>& points, const std::string& cells, std::int64_t per_cell,
                      const std::string& point_data) {
  const std::size_t n = points.size() / static_cast<std::size_t>(per_cell);
  return fmt::format(
      "<?xml version=\"1.0\"?>\n"
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
      "<PolyData>\n<Piece NumberOfPoints=\"{0}\" NumberOf{1}=\"{2}\">\n"
      "<PointData>\n{3}</PointData>\n<Points>\n{4}</Points>\n<{1}>\n{5}{6}</{1}>\n"
      "</Piece>\n</PolyData>\n</VTKFile>\n",
      points.size(), cells, n, point_data, array("Points", 3, flat(points)),
      array("connectivity", 1, counted(points.size(), 0, 1)), array("offsets", 1, counted(n, per_cell, per_cell)));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

}  // namespace

Vector3 folded(const Cell& cell, Vector3 position) {
  const Vector3 length = cell.lengths();
  for (int axis = 2; axis >= 0; --axis) {  // z first, because in a sheared cell folding along z changes x
    if (!cell.periodic[static_cast<std::size_t>(axis)]) continue;
    const double periods = std::floor((position[axis] - cell.lower[axis]) / length[axis]);
    position[axis] -= length[axis] * periods;
    if (axis == 2) position.x() -= periods * cell.shear_offset;
  }
  return position;
}

std::vector<Vector3> cell_edges(const Cell& cell) {
  std::vector<Vector3> points;
  for (int axis = 0; axis < 3; ++axis)
    for (int corner = 0; corner < 4; ++corner) {
      Vector3 point = cell.lower;
      if (corner % 2 == 1) point[(axis + 1) % 3] = cell.upper[(axis + 1) % 3];
      if (corner / 2 == 1) point[(axis + 2) % 3] = cell.upper[(axis + 2) % 3];
      points.push_back(point);
      point[axis] = cell.upper[axis];
      points.push_back(point);
    }
  return points;
}

void write_grains(const std::filesystem::path& path, const Assembly& assembly) {
  std::vector<Vector3> positions;
  for (const Vector3& position : assembly.position) positions.push_back(folded(assembly.cell, position));
  std::vector<std::uint8_t> roles;
  for (const Role role : assembly.role) roles.push_back(static_cast<std::uint8_t>(role));
  const std::string data = array("radius", 1, scaled(assembly.radius, 1.0)) +
                           array("diameter", 1, scaled(assembly.radius, 2.0)) +
                           array("velocity", 3, flat(assembly.velocity)) + array("spin", 3, flat(assembly.spin)) +
                           array("role", 1, roles);
  write_atomically(path, poly_data(positions, "Verts", 1, data));
}

void write_cell(const std::filesystem::path& path, const Cell& cell) {
  write_atomically(path, poly_data(cell_edges(cell), "Lines", 2, ""));
}

void write_collection(const std::filesystem::path& path, std::span<const Frame> frames) {
  std::string text =
      "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"1.0\" byte_order=\"LittleEndian\">\n"
      "<Collection>\n";
  for (const Frame& frame : frames) {
    if (!std::isfinite(frame.time)) throw std::invalid_argument("a frame whose time is not finite: " + frame.file);
    text += fmt::format("<DataSet timestep=\"{}\" part=\"{}\" file=\"{}\"/>\n", shortest(frame.time), frame.part,
                        escaped(frame.file));
  }
  write_atomically(path, text + "</Collection>\n</VTKFile>\n");
}

}  // namespace flowslide

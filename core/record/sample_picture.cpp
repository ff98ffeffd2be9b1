// SPDX-License-Identifier: GPL-2.0-or-later
#include "record/sample_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include "record/snapshot.hpp"

namespace flowslide {
namespace {

/// Rotation from the axes of the cell to those of the picture: across, up, towards the viewer.
Matrix3 rotation(const View& view) {
  const double a = view.azimuth * std::numbers::pi / 180.0, e = view.elevation * std::numbers::pi / 180.0;
  Matrix3 rows;
  rows.row(0) << -std::sin(a), std::cos(a), 0.0;
  rows.row(1) << -std::sin(e) * std::cos(a), -std::sin(e) * std::sin(a), std::cos(e);
  rows.row(2) << std::cos(e) * std::cos(a), std::cos(e) * std::sin(a), std::sin(e);
  return rows;
}

/// Shears a point of the upright cell by `strain`.
Vector3 sheared(Vector3 point, const Cell& cell, double strain) {
  point.x() += strain * (point.z() - cell.lower.z());
  return point;
}

struct Ball {
  Vector3 centre;  // across, up, towards the viewer
  double radius;
  Role role;
};

/// The grains from back to front.
std::vector<Ball> balls(const Assembly& assembly, const View& view) {
  const Matrix3 to_picture = rotation(view);
  std::vector<Ball> result;
  for (std::size_t i = 0; i < assembly.size(); ++i) {
    if (!assembly.position[i].allFinite() || !(assembly.radius[i] > 0.0))
      throw std::invalid_argument(fmt::format("grain {} has no place or no size and cannot be drawn", i));
    const Vector3 upright = folded(assembly.cell, sheared(assembly.position[i], assembly.cell, -view.shear_strain));
    const Vector3 place = sheared(upright, assembly.cell, view.shear_strain);
    result.push_back({to_picture * place, assembly.radius[i], assembly.role[i]});
  }
  std::ranges::stable_sort(result, {}, [](const Ball& ball) { return ball.centre.z(); });
  return result;
}

/// A coarse grid that stores, for each of its points, the ball that was painted last.
class Canvas {
 public:
  static constexpr std::uint32_t nobody = std::numeric_limits<std::uint32_t>::max();

  Canvas(const std::vector<Ball>& all, double spacing) : spacing_(spacing) {
    Vector3 lower = Vector3::Constant(std::numeric_limits<double>::infinity()), upper = -lower;
    for (const Ball& ball : all) {
      lower = lower.cwiseMin(ball.centre - Vector3::Constant(ball.radius));
      upper = upper.cwiseMax(ball.centre + Vector3::Constant(ball.radius));
    }
    lower_ = lower;
    width_ = points(upper.x() - lower.x());
    owner_.assign(width_ * points(upper.y() - lower.y()), nobody);
  }

  void paint(const Ball& ball, std::uint32_t name) {
    const double x = (ball.centre.x() - lower_.x()) / spacing_, y = (ball.centre.y() - lower_.y()) / spacing_;
    const double r = ball.radius / spacing_;
    for (double row = std::ceil(y - r); row <= y + r; ++row) {
      const double half = std::sqrt(std::max(0.0, r * r - (row - y) * (row - y)));
      for (double column = std::ceil(x - half); column <= x + half; ++column)
        owner_[static_cast<std::size_t>(std::max(row, 0.0)) * width_ +
               static_cast<std::size_t>(std::max(column, 0.0))] = name;
    }
  }

  const std::vector<std::uint32_t>& owners() const { return owner_; }

 private:
  std::size_t points(double length) const { return static_cast<std::size_t>(length / spacing_) + 2; }
  double spacing_;
  Vector3 lower_ = Vector3::Zero();
  std::size_t width_ = 0;
  std::vector<std::uint32_t> owner_;
};

/// The balls that other balls do not hide. In a dense sample most are hidden.
std::vector<Ball> visible(const std::vector<Ball>& all) {
  if (all.empty()) return {};
  constexpr double points_per_radius = 10.0;
  Canvas canvas(all, std::ranges::min(all, {}, &Ball::radius).radius / points_per_radius);
  for (std::size_t i = 0; i < all.size(); ++i) canvas.paint(all[i], static_cast<std::uint32_t>(i));
  std::vector<bool> seen(all.size(), false);
  for (const auto name : canvas.owners())
    if (name != Canvas::nobody) seen[name] = true;
  std::vector<Ball> result;
  for (std::size_t i = 0; i < all.size(); ++i)
    if (seen[i]) result.push_back(all[i]);
  return result;
}

/// The edges of the cell that are in front of the grains, or behind them: two ends, then an empty line, each.
std::string edge_rows(const Cell& cell, const View& view, bool in_front) {
  const Matrix3 to_picture = rotation(view);
  auto edges = cell_edges(cell);
  for (Vector3& point : edges) point = to_picture * sheared(point, cell, view.shear_strain);
  const Vector3 farthest = std::ranges::min(edges, {}, [](const Vector3& point) { return point.z(); });
  const double rounding = 1e-9 * cell.lengths().norm();
  std::string text;
  for (std::size_t i = 0; i < edges.size(); i += 2) {
    const bool behind = (edges[i] - farthest).norm() < rounding || (edges[i + 1] - farthest).norm() < rounding;
    if (behind == in_front) continue;
    for (const Vector3& point : {edges[i], edges[i + 1]})
      text += fmt::format("{} {} 0 0 {}\n", shortest(point.x()), shortest(point.y()), in_front ? 3 : 4);
    text += '\n';
  }
  return text;
}

}  // namespace

std::vector<Disc> draw_grains(const Assembly& assembly, const View& view) {
  if (view.shells < 1) throw std::invalid_argument(fmt::format("{} shells per grain; at least 1", view.shells));
  // Direction towards the light in the plane of the picture: the light comes from the upper left, from behind the
  // viewer.
  constexpr double light_across = -0.35, light_up = 0.5, rim_shade = 0.2;
  std::vector<Disc> discs;
  for (const Ball& ball : visible(balls(assembly, view)))
    for (int shell = 0; shell < view.shells; ++shell) {
      const double inwards = static_cast<double>(shell) / view.shells;
      discs.push_back({ball.centre.x() + light_across * inwards * ball.radius,
                       ball.centre.y() + light_up * inwards * ball.radius, (1.0 - inwards) * ball.radius,
                       rim_shade + (1.0 - rim_shade) * std::sin(0.5 * std::numbers::pi * inwards), ball.role});
    }
  return discs;
}

void write_picture(const std::filesystem::path& path, const Assembly& assembly, const View& view) {
  static_assert(static_cast<int>(Role::top_layer) == 2, "parts 3 and 4 are the edges");
  std::string text =
      table_head({{"across", "", "m", "place in the plane of the picture", "positive to the right", {}},
                  {"up", "", "m", "place in the plane of the picture", "positive upwards", {}},
                  {"radius", "", "m", "radius of the disc; 0 of an edge", "", {}},
                  {"shade", "", "1", "0 dark to 1 bright; 0 of an edge", "", {}},
                  {"part", "", "1",
                   "0 mobile grain, 1 bottom layer, 2 top layer, 3 edge of the cell in front, 4 edge behind", "", {}}});
  for (const Disc& disc : draw_grains(assembly, view))
    text += fmt::format("{:.6g} {:.6g} {:.6g} {:.3g} {}\n", disc.across, disc.up, disc.radius, disc.shade,
                        static_cast<int>(disc.role));
  text += '\n' + edge_rows(assembly.cell, view, true) + edge_rows(assembly.cell, view, false);
  write_atomically(path, text);
}

}  // namespace flowslide

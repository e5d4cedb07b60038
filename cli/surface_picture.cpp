// SPDX-License-Identifier: MIT
#include "cli/surface_picture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "arete/variational/cotangent.h"
#include "arete/vtk/image.h"

namespace arete::cli {
namespace {

constexpr int supersampling = 3;
constexpr double margin = 0.06;

// Turns the world so that the viewer looks along -z with +y upwards.
class Turn {
 public:
  explicit Turn(const SurfaceView& view) {
    const double degree = std::numbers::pi / 180;
    ca_ = std::cos(view.azimuth * degree);
    sa_ = std::sin(view.azimuth * degree);
    ce_ = std::cos(view.elevation * degree);
    se_ = std::sin(view.elevation * degree);
  }
  [[nodiscard]] Point3 operator()(const Point3& p) const {
    const double right = ca_ * p[0] + sa_ * p[1];
    const double away = -sa_ * p[0] + ca_ * p[1];
    return {right, se_ * away + ce_ * p[2], -ce_ * away + se_ * p[2]};
  }

 private:
  double ca_, sa_, ce_, se_;
};

struct Corner {
  Point3 place;  // pixels, and nearness
  Point3 normal;
};

struct Canvas {
  int columns;
  int rows;
  std::vector<double> nearness;
  vtk::Image image;

  explicit Canvas(const SurfaceView& view)
      : columns(view.width * supersampling), rows(view.height * supersampling) {
    const auto size = static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
    nearness.assign(size, -std::numeric_limits<double>::infinity());
    image = {columns, rows, std::vector<vtk::Rgb>(size, vtk::Rgb{255, 255, 255})};
  }
};

vtk::Rgb shade(const Point3& normal, bool dark) {
  const Point3 light{-0.35, 0.55, 0.76};
  const double size = length(normal);
  const double slope = size > 0 ? std::abs(dot(normal, light)) / size : 0;
  const double glow = 0.25 + 0.75 * slope;
  const std::array<double, 3> paint =
      dark ? std::array<double, 3>{70, 120, 180} : std::array<double, 3>{235, 225, 205};
  vtk::Rgb color{};
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(std::lround(std::min(255.0, paint[k] * glow)));
  return color;
}

void fill(const std::array<Corner, 3>& corners, bool dark, Canvas& canvas) {
  const Corner &a = corners[0], &b = corners[1], &c = corners[2];
  const double area = (b.place[0] - a.place[0]) * (c.place[1] - a.place[1]) -
                      (b.place[1] - a.place[1]) * (c.place[0] - a.place[0]);
  if (area == 0) return;
  const auto range = [&](std::size_t k, int most) {
    const auto [low, high] = std::minmax({a.place[k], b.place[k], c.place[k]});
    return std::pair{std::max(0, static_cast<int>(std::floor(low))),
                     std::min(most - 1, static_cast<int>(std::ceil(high)))};
  };
  const auto [x0, x1] = range(0, canvas.columns);
  const auto [y0, y1] = range(1, canvas.rows);
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      const double px = x + 0.5, py = y + 0.5;
      const auto edge = [&](const Corner& p, const Corner& q) {
        return ((q.place[0] - p.place[0]) * (py - p.place[1]) -
                (q.place[1] - p.place[1]) * (px - p.place[0])) /
               area;
      };
      const double wa = edge(b, c), wb = edge(c, a), wc = edge(a, b);
      if (wa < 0 || wb < 0 || wc < 0) continue;
      const double near = wa * a.place[2] + wb * b.place[2] + wc * c.place[2];
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(canvas.columns) +
          static_cast<std::size_t>(x);
      if (near <= canvas.nearness[pixel]) continue;
      canvas.nearness[pixel] = near;
      Point3 normal{};
      for (std::size_t k = 0; k < 3; ++k)
        normal[k] = wa * a.normal[k] + wb * b.normal[k] + wc * c.normal[k];
      canvas.image.pixels[pixel] = shade(normal, dark);
    }
}

}  // namespace

void draw_surface(const MinimalSurface& surface, const SurfaceView& view,
                  const std::filesystem::path& png) {
  const Turn turn(view);
  std::vector<Corner> corners;
  const std::vector<Point3> normals = unit_normals(surface.mesh);
  Point3 low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (std::size_t i = 0; i < surface.mesh.points.size(); ++i) {
    corners.push_back({turn(surface.mesh.points[i]), turn(normals[i])});
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], corners.back().place[k]);
      high[k] = std::max(high[k], corners.back().place[k]);
    }
  }
  Canvas canvas(view);
  const double unit =
      std::min(canvas.columns * (1 - 2 * margin) / std::max(high[0] - low[0], 1e-300),
               canvas.rows * (1 - 2 * margin) / std::max(high[1] - low[1], 1e-300));
  for (Corner& corner : corners) {
    corner.place[0] = canvas.columns / 2.0 + (corner.place[0] - (low[0] + high[0]) / 2) * unit;
    corner.place[1] = canvas.rows / 2.0 - (corner.place[1] - (low[1] + high[1]) / 2) * unit;
  }
  // Two triangles a quad, in the order of grid_triangles.
  const Index cells = surface.ring ? surface.samples.cols : surface.samples.cols - 1;
  const Index rows = surface.samples.rows - 1;
  for (std::size_t t = 0; t < surface.mesh.triangles.size(); ++t) {
    const auto quad = static_cast<Index>(t / 2);
    const bool dark = ((quad / cells * 16 / rows) + (quad % cells * 16 / cells)) % 2 != 0;
    const auto& [a, b, c] = surface.mesh.triangles[t];
    fill({corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)],
          corners[static_cast<std::size_t>(c)]},
         dark, canvas);
  }
  vtk::write_png(vtk::shrink(canvas.image, supersampling), png);
}

}  // namespace arete::cli

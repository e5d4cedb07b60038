// SPDX-License-Identifier: MIT
#include "cli/triangles_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "arete/vtk/image.h"
#include "cli/error.h"

namespace arete::cli {
namespace {

constexpr int supersampling = 3;
constexpr int longer_side = 1200;
constexpr int margin = 12;
constexpr double line_width = 0.9;  // pixels of the finished picture

struct Triangle {
  std::array<Point3, 3> corners;
  std::array<bool, 3> drawn;  // the edge from each corner to the next
};

// Calls back with the triangles of a fan over each face, whose inner edges are not drawn.
template <class Use>
void for_each_triangle(std::span<const Point3> points, const FaceList& faces, const Use& use) {
  for (int f = 0; f < faces.count(); ++f) {
    const std::span<const int> face = faces[f];
    const auto at = [&](std::size_t k) { return points[static_cast<std::size_t>(face[k])]; };
    for (std::size_t k = 1; k + 1 < face.size(); ++k)
      use(Triangle{{at(0), at(k), at(k + 1)}, {k == 1, true, k + 2 == face.size()}});
  }
}

// Height differences to the east and to the north, a unit of length, and the area.
struct Tilt {
  double east = 0, north = 0, area = 0;
};

Tilt tilt_of(const Triangle& t) {
  const auto& [a, b, c] = t.corners;
  const double ux = b[0] - a[0], uy = b[1] - a[1], uz = b[2] - a[2];
  const double vx = c[0] - a[0], vy = c[1] - a[1], vz = c[2] - a[2];
  const double area = ux * vy - uy * vx;
  if (area == 0) return {};
  return {(uz * vy - vz * uy) / area, (vz * ux - uz * vx) / area, std::abs(area)};
}

double mean_slope(std::span<const Point3> points, const FaceList& faces) {
  double sum = 0, area = 0;
  for_each_triangle(points, faces, [&](const Triangle& t) {
    const Tilt tilt = tilt_of(t);
    sum += std::hypot(tilt.east, tilt.north) * tilt.area;
    area += tilt.area;
  });
  return area > 0 ? sum / area : 0;
}

struct Box {
  Point3 low, high;
};

Box box_of(std::span<const Point3> points) {
  Box box;
  box.low.fill(std::numeric_limits<double>::infinity());
  box.high.fill(-std::numeric_limits<double>::infinity());
  for (const Point3& p : points)
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = std::min(box.low[k], p[k]);
      box.high[k] = std::max(box.high[k], p[k]);
    }
  return box;
}

vtk::Rgb tone(const Tilt& tilt, double exaggeration, double height) {
  const double x = -tilt.east * exaggeration;
  const double y = -tilt.north * exaggeration;
  const double lit = (-0.5 * x + 0.5 * y + std::sqrt(0.5)) / std::sqrt(1 + x * x + y * y);
  const double glow = 0.45 + 0.6 * std::max(0.0, lit);
  constexpr std::array<double, 3> valley{150, 180, 130};
  constexpr std::array<double, 3> summit{240, 228, 205};
  vtk::Rgb color{};
  for (std::size_t k = 0; k < 3; ++k)
    color[k] = static_cast<std::uint8_t>(
        std::lround(std::clamp(glow * (valley[k] + (summit[k] - valley[k]) * height), 0.0, 255.0)));
  return color;
}

// `corners` in pixels of the large picture.
void fill(const Triangle& t, const vtk::Rgb& color, vtk::Image& image) {
  const auto& p = t.corners;
  const auto cross = [](const Point3& a, const Point3& b, double x, double y) {
    return (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
  };
  const double area = cross(p[0], p[1], p[2][0], p[2][1]);
  if (area == 0) return;
  const auto range = [&](std::size_t k, int most) {
    const auto [low, high] = std::minmax({p[0][k], p[1][k], p[2][k]});
    return std::pair{std::max(0, static_cast<int>(std::floor(low))),
                     std::min(most - 1, static_cast<int>(std::ceil(high)))};
  };
  const auto [x0, x1] = range(0, image.width);
  const auto [y0, y1] = range(1, image.height);
  constexpr vtk::Rgb ink{52, 56, 70};
  for (int y = y0; y <= y1; ++y)
    for (int x = x0; x <= x1; ++x) {
      bool inside = true;
      bool on_edge = false;
      for (std::size_t k = 0; k < 3 && inside; ++k) {
        const Point3& a = p[k];
        const Point3& b = p[(k + 1) % 3];
        const double away = cross(a, b, x + 0.5, y + 0.5) * (area > 0 ? 1 : -1);
        inside = away >= 0;
        on_edge = on_edge || (t.drawn[k] && away < line_width * supersampling / 2 *
                                                       std::hypot(b[0] - a[0], b[1] - a[1]));
      }
      if (inside)
        image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                     static_cast<std::size_t>(x)] = on_edge ? ink : color;
    }
}

}  // namespace

void draw_triangles(std::span<const Point3> points, const FaceList& faces,
                    const std::filesystem::path& picture) {
  if (faces.count() == 0)
    throw Failure(
        "there is no triangle to draw; the raster needs at least 2 x 2 samples that are not "
        "missing");
  const Box box = box_of(points);
  const double across = box.high[0] - box.low[0];
  const double along = box.high[1] - box.low[1];
  const double unit = (longer_side - 2 * margin) * supersampling / std::max(across, along);
  const auto pixels = [&](double length) {
    return (static_cast<int>(std::ceil(length * unit / supersampling)) + 2 * margin) *
           supersampling;
  };
  vtk::Image image{pixels(across), pixels(along), {}};
  image.pixels.assign(
      static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
      vtk::Rgb{255, 255, 255});
  const double slope = mean_slope(points, faces);
  const double exaggeration = slope > 0 ? 0.5 / slope : 1;
  const double relief = std::max(box.high[2] - box.low[2], 1e-300);
  for_each_triangle(points, faces, [&](Triangle t) {
    const Tilt tilt = tilt_of(t);
    const double height =
        ((t.corners[0][2] + t.corners[1][2] + t.corners[2][2]) / 3 - box.low[2]) / relief;
    for (Point3& p : t.corners) {
      p[0] = margin * supersampling + (p[0] - box.low[0]) * unit;
      p[1] = margin * supersampling + (box.high[1] - p[1]) * unit;
    }
    fill(t, tone(tilt, exaggeration, height), image);
  });
  vtk::write_picture(vtk::shrink(image, supersampling), picture);
}

}  // namespace arete::cli

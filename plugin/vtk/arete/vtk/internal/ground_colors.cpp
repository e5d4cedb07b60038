// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/ground_colors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "arete/vtk/colormap.h"
#include "arete/vtk/internal/gradient.h"

namespace arete::vtk {
namespace {

constexpr double degree = 180 / std::numbers::pi;

/// Bilinear between pixel centres, the border continued.
Rgb sample(const Image& image, double x, double y) {
  x = std::clamp(x, 0.0, static_cast<double>(image.width - 1));
  y = std::clamp(y, 0.0, static_cast<double>(image.height - 1));
  const int x0 = static_cast<int>(x);
  const int y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, image.width - 1);
  const int y1 = std::min(y0 + 1, image.height - 1);
  const double s = x - x0;
  const double t = y - y0;
  Rgb color;
  for (std::size_t c = 0; c < 3; ++c) {
    const double top = (1 - s) * image(x0, y0)[c] + s * image(x1, y0)[c];
    const double low = (1 - s) * image(x0, y1)[c] + s * image(x1, y1)[c];
    color[c] = static_cast<std::uint8_t>(std::lround((1 - t) * top + t * low));
  }
  return color;
}

/// Where the middle of pixel i of `count` lies among the samples of an axis.
double sample_position(int i, int count, Index original, const AxisPlacement& axis) {
  const double at = (i + 0.5) / count * static_cast<double>(original) - 0.5;
  return (at - axis.first) / axis.spacing;
}

}  // namespace

std::array<double, 2> height_range(const Surface& surface) {
  std::array<double, 2> range{std::numeric_limits<double>::infinity(),
                              -std::numeric_limits<double>::infinity()};
  const Extent extent = surface.extent();
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      if (!surface.valid(r, c)) continue;
      range[0] = std::min(range[0], surface.height(r, c));
      range[1] = std::max(range[1], surface.height(r, c));
    }
  }
  return range;
}

Image ground_colors(const Stage& stage, const Appearance& appearance,
                    const std::array<double, 2>& range) {
  const Surface& surface = stage.surface();
  const Extent extent = surface.extent();
  const Colormap& colormap = find_colormap(appearance.colormap);
  const GradientField gradients(surface, stage.plane());
  const auto share = [&](double height) {
    return range[1] > range[0] ? (height - range[0]) / (range[1] - range[0]) : 0.5;
  };
  const auto color = [&](Index row, Index col) {
    const double height = surface.height(row, col);
    if (!appearance.palette) return colormap(share(height));
    const Palette& palette = *appearance.palette;
    const Gradient g = gradients.at(row, col);
    const double steepness =
        std::hypot(g.dx, g.dy) * (palette.drawn_slopes ? stage.exaggeration() : 1);
    return palette({palette.relative_heights ? share(height) : height,
                    std::atan(steepness) * degree, std::atan2(-g.dx, -g.dy) * degree});
  };
  Image image{static_cast<int>(extent.cols), static_cast<int>(extent.rows), {}};
  image.pixels.resize(static_cast<std::size_t>(extent.rows * extent.cols), colormap(0));
  for (Index row = 0; row < extent.rows; ++row) {
    for (Index col = 0; col < extent.cols; ++col) {
      if (surface.valid(row, col))
        image.pixels[static_cast<std::size_t>(row * extent.cols + col)] = color(row, col);
    }
  }
  return image;
}

Image textured(const Texture& texture, const Image& ground, const ReducedSurface& reduced,
               Extent original) {
  Image image = texture.image;
  if (texture.opacity.empty()) return image;
  std::size_t k = 0;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x, ++k) {
      const int opacity = texture.opacity[k];
      if (opacity == 255) continue;
      const Rgb below = sample(ground, sample_position(x, image.width, original.cols, reduced.cols),
                               sample_position(y, image.height, original.rows, reduced.rows));
      for (std::size_t c = 0; c < 3; ++c) {
        image.pixels[k][c] = static_cast<std::uint8_t>(
            (opacity * image.pixels[k][c] + (255 - opacity) * below[c] + 127) / 255);
      }
    }
  }
  return image;
}

}  // namespace arete::vtk

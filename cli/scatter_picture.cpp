// SPDX-License-Identifier: MIT
#include "cli/scatter_picture.h"

#include <algorithm>
#include <cmath>

#include "arete/vtk/image.h"

namespace arete::cli {

ScatterPicture::ScatterPicture(std::vector<double> low, std::vector<double> high)
    : centre_x_((low[0] + high[0]) / 2),
      centre_y_((low[1] + high[1]) / 2),
      scale_(std::min((width - 2 * margin) / std::max(high[0] - low[0], 1e-300),
                      (height - 2 * margin) / std::max(high[1] - low[1], 1e-300))),
      counts_(static_cast<std::size_t>(width) * height, 0) {}

void ScatterPicture::add(const std::vector<double>& point) {
  const double x = std::floor(width / 2.0 + (point[0] - centre_x_) * scale_);
  const double y = std::floor(height / 2.0 - (point[1] - centre_y_) * scale_);
  if (!(x >= 0 && x < width && y >= 0 && y < height)) return;
  std::uint32_t& count = counts_[static_cast<std::size_t>(y) * width + static_cast<std::size_t>(x)];
  if (count != UINT32_MAX) ++count;
}

void ScatterPicture::write(const std::filesystem::path& png) const {
  // Half of the pixels that were hit are as dark as it gets.
  std::vector<std::uint32_t> hit;
  for (const std::uint32_t count : counts_)
    if (count > 0) hit.push_back(count);
  std::uint32_t full = 1;
  if (!hit.empty()) {
    const auto middle = hit.begin() + static_cast<std::ptrdiff_t>(hit.size() / 2);
    std::nth_element(hit.begin(), middle, hit.end());
    full = *middle;
  }
  constexpr vtk::Rgb ink{31, 92, 153};
  vtk::Image image{width, height, {}};
  for (const std::uint32_t count : counts_) {
    const double share =
        count == 0 ? 0 : 0.35 + 0.65 * std::min(1.0, static_cast<double>(count) / full);
    vtk::Rgb pixel{};
    for (std::size_t k = 0; k < 3; ++k)
      pixel[k] = static_cast<std::uint8_t>(std::lround(255 - share * (255 - ink[k])));
    image.pixels.push_back(pixel);
  }
  vtk::write_png(image, png);
}

}  // namespace arete::cli

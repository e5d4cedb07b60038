// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <vector>

namespace arete::vtk {

/// Red, green, blue as they stand in a file (sRGB).
using Rgb = std::array<std::uint8_t, 3>;

/// A picture: rows from the top, pixels from the left.
struct Image {
  int width = 0;
  int height = 0;
  std::vector<Rgb> pixels{};

  [[nodiscard]] const Rgb& operator()(int x, int y) const {
    return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                  static_cast<std::size_t>(x)];
  }
};

/// The bytes of a PNG. \throws WriteError naming `path` when the picture is empty or has not width
/// x height pixels.
[[nodiscard]] std::vector<std::uint8_t> encode_png(const Image& image,
                                                   const std::filesystem::path& path);

/// \throws WriteError also when the picture is empty or has not width x height pixels.
void write_png(const Image& image, const std::filesystem::path& path);

/// As a JPEG of quality 92 if the name ends in .jpg or .jpeg, as a PNG otherwise.
/// \throws WriteError as write_png does.
void write_picture(const Image& image, const std::filesystem::path& path);

/// The mean of every factor x factor block, taken in linear light: on gamma-coded values edges
/// against a light background would come out too dark. Sizes are multiples of the factor.
[[nodiscard]] Image shrink(const Image& image, int factor);

}  // namespace arete::vtk

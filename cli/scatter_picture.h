// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

namespace arete::cli {

/// A picture of a cloud of points, dark where many fall: memory is that of the picture, whatever
/// their number.
class ScatterPicture {
 public:
  /// The box that the points are expected in, {x, y} of two opposite corners; points outside it are
  /// not drawn. A box without width or height is widened.
  ScatterPicture(std::vector<double> low, std::vector<double> high);
  /// The first two coordinates count.
  void add(const std::vector<double>& point);
  void write(const std::filesystem::path& png) const;

 private:
  static constexpr int width = 1000;
  static constexpr int height = 800;
  static constexpr int margin = 40;

  double centre_x_, centre_y_, scale_;
  std::vector<std::uint32_t> counts_;
};

}  // namespace arete::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace arete {

/// A point in space. Only used to choose between answers that topology leaves open.
using Point3 = std::array<double, 3>;

/// The faces of a mesh as plain vertex numbers: face f has the corners
/// corners[starts[f]] .. corners[starts[f + 1] - 1] in order around it. Nothing is checked here.
struct FaceList {
  std::vector<int> starts{0};
  std::vector<int> corners;

  [[nodiscard]] int count() const { return static_cast<int>(starts.size()) - 1; }
  [[nodiscard]] std::span<const int> operator[](int face) const {
    const auto f = static_cast<std::size_t>(face);
    return std::span<const int>(corners).subspan(
        static_cast<std::size_t>(starts[f]), static_cast<std::size_t>(starts[f + 1] - starts[f]));
  }
  void add(std::span<const int> face) {
    corners.insert(corners.end(), face.begin(), face.end());
    starts.push_back(static_cast<int>(corners.size()));
  }
};

}  // namespace arete

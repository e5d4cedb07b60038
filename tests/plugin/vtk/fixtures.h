// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <ostream>
#include <random>
#include <string>

#include "arete/field/georeference.h"
#include "arete/field/grid.h"
#include "arete/vtk/surface.h"

namespace arete {

/// How GoogleTest names a case with a map as its parameter.
inline void PrintTo(const Georeference& georeference, std::ostream* out) {  // NOLINT: its spelling
  for (const double value : georeference.affine) *out << value << ' ';
}

}  // namespace arete

namespace arete::vtk {

inline constexpr float missing = std::numeric_limits<float>::quiet_NaN();

/// A folder of one test's own, gone with it.
class Scratch {
 public:
  Scratch()
      : folder_(
            std::filesystem::temp_directory_path() /
            ("arete-vtk-" + std::to_string(std::random_device{}()) + std::to_string(count_++))) {
    std::filesystem::create_directories(folder_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;

  [[nodiscard]] std::filesystem::path operator/(const std::string& name) const {
    return folder_ / name;
  }

 private:
  static inline int count_ = 0;
  std::filesystem::path folder_;
};

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Maps of samples to the world. All but utm are exact in binary.
inline const Georeference north_up{{100, 2, 0, 300, 0, -4}};
inline const Georeference south_up{{100, 2, 0, 300, 0, 4}};
inline const Georeference mirrored{{100, -2, 0, 300, 0, -4}};
inline const Georeference rotated{{100, 1.5, 2, 300, 2, -1.5}};
inline const Georeference quarter_turn{{100, 0, 2, 300, 2, 0}};
inline const Georeference sheared{{100, 2, 1, 300, 0, -4}};
inline const Georeference utm{{399960.1, 90.0 / 7, 0, 5300040.3, 0, -90.0 / 7}};
inline const Georeference jacksboro{{-84.41375, 1.0 / 1200, 0, 36.732917, 0, -1.0 / 1200}};

/// Heights given by a function of the world position.
template <class T, class Height>
Grid<T> planted(Extent extent, const Georeference& georeference, Height height) {
  Grid<T> grid(extent);
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      const WorldPoint at = georeference.position(static_cast<double>(r), static_cast<double>(c));
      grid(r, c) = static_cast<T>(height(at.x, at.y));
    }
  }
  return grid;
}

/// Tells x from y, and every direction from its opposite.
inline double plane_height(double x, double y) { return 10 + 3 * x - 2 * y; }

template <class T>
Surface surface_of(const Grid<T>& grid, const Georeference& georeference) {
  return {.heights = grid.view(), .georeference = georeference};
}

}  // namespace arete::vtk

// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

#include "arete/field/grid.h"
#include "arete/refine/axis_places.h"
#include "arete/refine/axis_window.h"

namespace arete::vtk_filters {

/// A place on an axis as the two held samples around it, the part t of the way.
struct Between {
  Index near = 0;
  Index far = 0;
  double t = 0;
};

/// The places as samples of a window. They are counted from the first sample of the whole input; on
/// a periodic axis the window may hold them some turns further on.
[[nodiscard]] inline std::vector<Between> within(const std::vector<AxisPlace>& places,
                                                 IndexRange window, const AxisPlan& whole) {
  const Index count = whole.input_count();
  std::vector<Between> result;
  result.reserve(places.size());
  for (const AxisPlace& place : places) {
    Index near = place.cell - window.first;
    if (whole.boundary() == Boundary::periodic) near -= floor_divide(near, count) * count;
    result.push_back({near, std::min(near + 1, window.count() - 1), place.t});
  }
  return result;
}

/// The places as samples of a whole axis, the first following the last.
[[nodiscard]] inline std::vector<Between> around(const std::vector<AxisPlace>& places,
                                                 Index count) {
  std::vector<Between> result;
  result.reserve(places.size());
  for (const AxisPlace& place : places)
    result.push_back({place.cell, (place.cell + 1) % count, place.t});
  return result;
}

/// Exactly a sample where t is 0, also beside missing ones.
template <class T>
[[nodiscard]] T bilinear(const Grid<T>& plane, const Between& y, const Between& x) {
  const auto mix = [](double a, double b, double t) { return t == 0 ? a : a + t * (b - a); };
  const auto along = [&](Index r) {
    return mix(static_cast<double>(plane(r, x.near)), static_cast<double>(plane(r, x.far)), x.t);
  };
  return static_cast<T>(y.t == 0 ? along(y.near) : mix(along(y.near), along(y.far), y.t));
}

}  // namespace arete::vtk_filters

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/cgal/internal/outliers.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "arete/cgal/internal/gradients.h"

namespace arete::cgal::detail {
namespace {

double median(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

Index remove_outliers(Delaunay& dt, double limit) {
  constexpr double robust = 1.4826;  // MAD to standard deviation for normal errors
  const auto most = static_cast<Index>(dt.number_of_vertices() / 10);
  Index removed = 0;
  while (dt.number_of_vertices() > 4 && removed < most) {
    std::unordered_map<Vertex, double, CGAL::Handle_hash_function> off;
    std::vector<double> sizes;
    for (Vertex v : dt.finite_vertex_handles()) {
      const double distance = std::abs(v->info().z - plane_through_neighbours(dt, v));
      off.emplace(v, distance);
      sizes.push_back(distance);
    }
    const double allowed = limit * robust * median(std::move(sizes));
    std::vector<Vertex> worst;
    for (Vertex v : dt.finite_vertex_handles()) {
      const double distance = off.at(v);
      // Rounding alone is no deviation.
      if (!(distance > allowed) || distance <= 1e-12 * std::abs(v->info().z)) continue;
      bool highest = true;
      auto around = dt.incident_vertices(v);
      const auto done = around;
      do {
        if (!dt.is_infinite(around) && off.at(around) > distance) highest = false;
      } while (++around != done);
      if (highest) worst.push_back(v);
    }
    if (worst.empty()) break;
    for (const Vertex v : worst) {
      if (removed == most || dt.number_of_vertices() <= 4) break;
      dt.remove(v);
      ++removed;
    }
  }
  return removed;
}

}  // namespace arete::cgal::detail

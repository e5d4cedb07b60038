// SPDX-License-Identifier: MIT
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "arete/reverse/mesh_step.h"

namespace arete::test {

struct PlacedMesh {
  MeshFaces faces;
  Grid<double> positions;
};

/// Expects both to be the same mesh up to all orders; vertices are matched by their positions.
inline void expect_same_mesh(const PlacedMesh& actual, const PlacedMesh& expected, double close,
                             const std::string& what) {
  ASSERT_EQ(actual.faces.vertices, expected.faces.vertices) << what;
  std::vector<Index> match;
  std::set<Index> used;
  for (Index v = 0; v < actual.faces.vertices; ++v) {
    double best = 1e300;
    Index nearest = 0;
    for (Index w = 0; w < expected.faces.vertices; ++w) {
      double distance = 0;
      for (Index c = 0; c < 3; ++c)
        distance = std::max(distance, std::abs(actual.positions(v, c) - expected.positions(w, c)));
      if (distance < best) {
        best = distance;
        nearest = w;
      }
    }
    ASSERT_LE(best, close) << what << ", vertex " << v;
    match.push_back(nearest);
    used.insert(nearest);
  }
  ASSERT_EQ(used.size(), match.size()) << what;
  std::multiset<std::vector<Index>> a;
  std::multiset<std::vector<Index>> b;
  const auto turned = [](std::vector<Index> face) {
    std::rotate(face.begin(), std::min_element(face.begin(), face.end()), face.end());
    return face;
  };
  for (auto face : actual.faces.faces) {
    for (Index& v : face) v = match[static_cast<std::size_t>(v)];
    a.insert(turned(face));
  }
  for (const auto& face : expected.faces.faces) b.insert(turned(face));
  EXPECT_EQ(a, b) << what;
}

}  // namespace arete::test

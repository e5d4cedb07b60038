// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "arete/field/grid.h"

namespace arete::bench {

/// Heights on a grid, to be refined by the cubic B-spline / Catmull-Clark or resampled 2^levels
/// times.
struct Job {
  Grid<float> heights;
  int levels = 4;

  [[nodiscard]] Index fine(Index n) const { return ((n - 1) << levels) + 1; }
  [[nodiscard]] Extent fine() const { return {fine(heights.rows()), fine(heights.cols())}; }
};

/// One vertex of a refined mesh; x runs along a row of the input grid, y from row to row.
struct Vertex {
  float x, y, z;
};

/// A run of a peer: what is timed, and how its vertices are read afterwards (none for images).
struct Run {
  std::function<void()> work;
  std::function<std::vector<Vertex>()> vertices;
};

/// Another program that does the same job.
struct Peer {
  std::string name;
  bool points = false;    ///< x, y and z rather than heights
  bool one_shot = false;  ///< allocates its result in the timed part
  double goal = 0;        ///< at least so many times the time of arete
  int repetitions = 3;
  std::function<Run(const Job&)> prepare;  ///< set-up that is not timed
};

std::vector<Peer> opensubdiv_peers();
std::vector<Peer> openmesh_peers();
std::vector<Peer> cgal_peers();
std::vector<Peer> vtk_peers();
std::vector<Peer> gdal_peers();

}  // namespace arete::bench

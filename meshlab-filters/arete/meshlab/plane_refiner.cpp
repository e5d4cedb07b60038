// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/plane_refiner.h"

#include <algorithm>

namespace arete::meshlab {

Grid<double> coordinate_plane(const MeshArrays& mesh, const GridPatch& patch,
                              std::size_t coordinate) {
  Grid<double> plane(patch.extent);
  std::transform(patch.vertices.begin(), patch.vertices.end(), plane.samples().begin(),
                 [&](int v) { return mesh.positions[static_cast<std::size_t>(v)][coordinate]; });
  return plane;
}

Grid<double> refined_plane(const Refiner<double>& refiner, const Grid<double>& plane,
                           const Report& report, int begin, int end) {
  constexpr Index bands = 32;
  Grid<double> result(refiner.output());
  const Index rows = result.rows();
  const Index band_rows = std::max(Index{64}, (rows + bands - 1) / bands);
  const GridSource<double> source(plane.view());
  for (Index row = 0; row < rows; row += band_rows) {
    report.progress(begin + static_cast<int>((end - begin) * row / rows), "Refining");
    refiner.refine_rows(
        source, row,
        GridView<double>(result.row(row), {std::min(band_rows, rows - row), result.cols()}));
  }
  return result;
}

}  // namespace arete::meshlab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/refined_patch.h"

#include <utility>

#include "arete/field/at.h"

namespace arete::meshlab {
namespace {

}  // namespace

RefinedPatch::RefinedPatch(const GridPatch& patch, AxisSamples rows, AxisSamples cols,
                           int& next_vertex)
    : patch_(&patch), rows_(std::move(rows)), cols_(std::move(cols)) {
  number_vertices(next_vertex);
}

void RefinedPatch::number_vertices(int& next_vertex) {
  const Extent fine = extent();
  vertices_.assign(at(fine.rows * fine.cols), -1);
  for (Index r = 0; r < patch_->extent.rows; ++r) {
    for (Index c = 0; c < patch_->extent.cols; ++c) {
      const Index row = rows_.successors()[at(r)];
      const Index col = cols_.successors()[at(c)];
      if (row < 0 || col < 0)
        dropped_.push_back(patch_->vertex(r, c));
      else
        vertices_[at(row * fine.cols + col)] = patch_->vertex(r, c);
    }
  }
  for (int& vertex : vertices_)
    if (vertex < 0) vertex = next_vertex++;
}

}  // namespace arete::meshlab

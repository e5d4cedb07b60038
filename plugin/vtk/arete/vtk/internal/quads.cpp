// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/quads.h"

#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkTypeInt32Array.h>
#include <vtkTypeInt64Array.h>

#include <array>
#include <cstdint>
#include <limits>

#include "arete/vtk/internal/sample_order.h"

namespace arete::vtk {
namespace {

/// Calls visit(row, col) for the least corner of every quad that is whole.
template <class Visit>
void for_each_quad(const Surface& surface, Visit visit) {
  const Extent extent = surface.extent();
  for (Index row = 0; row + 1 < extent.rows; ++row) {
    for (Index col = 0; col + 1 < extent.cols; ++col) {
      if (whole_quad(surface, row, col)) visit(row, col);
    }
  }
}

template <class IdArray>
void fill(const Surface& surface, const std::vector<Index>& point_of, Index quads,
          vtkPolyData& out) {
  const Index cols = surface.extent().cols;
  const bool clockwise = right_handed_order(surface).flip_rows;
  vtkNew<IdArray> offsets;
  vtkNew<IdArray> corners;
  offsets->SetNumberOfValues(quads + 1);
  corners->SetNumberOfValues(4 * quads);
  using Id = typename IdArray::ValueType;
  Index next = 0;  // corner; four to a quad
  for_each_quad(surface, [&](Index row, Index col) {
    const Index at = row * cols + col;
    // In (col, row) order the corners turn counter-clockwise when that frame is right-handed.
    const std::array<Index, 4> turn = clockwise ? std::array{at, at + cols, at + cols + 1, at + 1}
                                                : std::array{at, at + 1, at + cols + 1, at + cols};
    offsets->SetValue(next / 4, static_cast<Id>(next));
    for (const Index sample : turn) {
      corners->SetValue(next++, static_cast<Id>(point_of[static_cast<std::size_t>(sample)]));
    }
  });
  offsets->SetValue(quads, static_cast<Id>(next));
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);
  out.SetPolys(cells);
}

}  // namespace

std::vector<Index> set_quads(const Surface& surface, vtkPolyData& out) {
  const Extent extent = surface.extent();
  std::vector<Index> point_of(static_cast<std::size_t>(extent.rows * extent.cols), -1);
  Index quads = 0;
  for_each_quad(surface, [&](Index row, Index col) {
    const Index at = row * extent.cols + col;
    for (const Index corner : {at, at + 1, at + extent.cols, at + extent.cols + 1}) {
      point_of[static_cast<std::size_t>(corner)] = 0;
    }
    ++quads;
  });
  std::vector<Index> samples;
  for (std::size_t sample = 0; sample < point_of.size(); ++sample) {
    if (point_of[sample] < 0) continue;
    point_of[sample] = static_cast<Index>(samples.size());
    samples.push_back(static_cast<Index>(sample));
  }
  if (4 * quads <= std::numeric_limits<std::int32_t>::max()) {
    fill<vtkTypeInt32Array>(surface, point_of, quads, out);
  } else {
    fill<vtkTypeInt64Array>(surface, point_of, quads, out);
  }
  return samples;
}

}  // namespace arete::vtk

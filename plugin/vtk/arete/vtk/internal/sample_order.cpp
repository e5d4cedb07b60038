// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/sample_order.h"

namespace arete::vtk {

SampleOrder right_handed_order(const Surface& surface) {
  const auto& g = surface.georeference.affine;
  return {surface.extent(), g[1] * g[5] - g[2] * g[4] < 0, false};
}

}  // namespace arete::vtk

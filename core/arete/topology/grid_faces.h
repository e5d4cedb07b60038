// SPDX-License-Identifier: MIT
#pragma once

#include "arete/field/grid.h"
#include "arete/topology/face_list.h"

namespace arete {

/// The quads of a grid whose vertices are numbered row by row: face r (cols - 1) + c is
/// (r, c), (r, c+1), (r+1, c+1), (r+1, c). With rows going south and columns east that is clockwise
/// seen from above; `mirrored` turns every face over. An axis that wraps has one more cell.
/// \throws InvalidField if there are more than 2^31 - 1 corners.
[[nodiscard]] FaceList grid_faces(Extent extent, bool mirrored = false, bool wraps_rows = false,
                                  bool wraps_cols = false);

}  // namespace arete

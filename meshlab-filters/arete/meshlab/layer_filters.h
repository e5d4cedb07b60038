// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/meshlab/filter_table.h"

namespace arete::meshlab {

// Rows of the table whose result is a new layer.
[[nodiscard]] Filter coarsen_filter();
/// Only in builds with CGAL.
[[nodiscard]] Filter points_filter();

}  // namespace arete::meshlab

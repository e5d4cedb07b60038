// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/cgal/internal/delaunay.h"
#include "arete/field/grid.h"

namespace arete::cgal::detail {

/// Removes points whose height lies further than `limit` robust standard deviations (1.4826 times
/// the median absolute deviation, all points) from the plane through their neighbours, if no
/// neighbour lies further off; again until none is left or every tenth point is gone.
/// \pre dimension 2, limit > 0. \return how many were removed.
Index remove_outliers(Delaunay& dt, double limit);

}  // namespace arete::cgal::detail

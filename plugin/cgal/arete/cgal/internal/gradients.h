// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/cgal/internal/delaunay.h"
#include "arete/cgal/internal/parallel.h"

namespace arete::cgal::detail {

/// Which points get a gradient.
enum class GradientsAt { hull, everywhere };

/// Fits the gradient of every site: Sibson's within the hull (by CGAL), on the hull, where there
/// are no natural neighbours all around, that of the least squares fit of a + b.x + c |x|^2 to the
/// neighbours and theirs. Both are exact for that function. \pre dimension 2.
void fit_gradients(Delaunay& dt, GradientsAt where, int threads, const Tell& tell);

/// The plane through the neighbours of a vertex (not itself) by least squares, at the vertex; its
/// value there.
[[nodiscard]] double plane_through_neighbours(const Delaunay& dt, Vertex vertex);

}  // namespace arete::cgal::detail

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <utility>
#include <vector>

namespace arete::cgal::detail {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_2;
using Vector = Kernel::Vector_2;

/// What a point knows: its height, and the surface's gradient there once fitted.
struct Site {
  double z = 0;
  Vector gradient{0, 0};
};

using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel,
                                   CGAL::Triangulation_data_structure_2<
                                       CGAL::Triangulation_vertex_base_with_info_2<Site, Kernel>>>;
using Vertex = Delaunay::Vertex_handle;
using Face = Delaunay::Face_handle;
using Weights = std::vector<std::pair<Vertex, double>>;

}  // namespace arete::cgal::detail

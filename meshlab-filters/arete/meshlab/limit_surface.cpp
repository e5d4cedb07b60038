// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/limit_surface.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "arete/analysis/limit_stencil.h"
#include "arete/field/at.h"
#include "arete/meshlab/plane_refiner.h"
#include "arete/meshlab/surface_patch.h"

namespace arete::meshlab {
namespace {

using Planes = std::array<Grid<double>, 3>;

// The filters along one axis of a patch. Cells: exactly one result per vertex.
AxisPlan axis_plan(const Scheme& scheme, Index count, bool wraps, Boundary boundary,
                   const Stencil& stencil) {
  AxisOptions options;
  options.levels = 0;
  options.boundary = wraps ? Boundary::periodic : boundary;
  options.alignment = Alignment::cells;
  options.final_stencil = stencil;
  return {scheme.mask(), count, options};
}

struct LimitStencils {
  Stencil limit;
  std::optional<Stencil> derivative;
};

LimitStencils stencils_of(const Scheme& scheme) {
  auto limit = limit_stencil(scheme.mask());
  if (!limit)
    throw InvalidScheme(scheme.text() +
                        " is not certified to converge, so it has no limit to move the vertices "
                        "to; choose another scheme ('Arete: Smoothness To Log' tells more)");
  return {std::move(*limit), derivative_stencil(scheme.mask())};
}

// A plane at places moved by a part of a cell, linearly; beyond open rims it is continued.
Grid<double> shifted(const Grid<double>& plane, const GridPatch& patch, double down, double right) {
  struct Place {
    Index cell, next;
    double t;
  };
  const auto place = [](Index i, double shift, Index count, bool wraps) {
    auto cell = i + static_cast<Index>(std::floor(shift));
    double t = shift - std::floor(shift);
    if (wraps) {
      cell = ((cell % count) + count) % count;
    } else {
      const Index inside = std::clamp(cell, Index{0}, count - 2);
      t += static_cast<double>(cell - inside);
      cell = inside;
    }
    return Place{cell, cell + 1 < count ? cell + 1 : 0, t};
  };
  Grid<double> result(plane.extent());
  for (Index r = 0; r < plane.rows(); ++r) {
    const Place y = place(r, down, plane.rows(), patch.wraps_rows);
    for (Index c = 0; c < plane.cols(); ++c) {
      const Place x = place(c, right, plane.cols(), patch.wraps_cols);
      const auto along = [&](Index row) {
        return (1 - x.t) * plane(row, x.cell) + x.t * plane(row, x.next);
      };
      result(r, c) = y.t == 0 && x.t == 0 ? plane(y.cell, x.cell)
                                          : (1 - y.t) * along(y.cell) + y.t * along(y.next);
    }
  }
  return result;
}

class LimitPatch {
 public:
  LimitPatch(const MeshArrays& mesh, const GridPatch& patch, const Scheme& scheme,
             const LimitStencils& stencils, const SubdivideOptions& options, const Report& report)
      : patch_(patch),
        scheme_(scheme),
        stencils_(stencils),
        options_(options),
        report_(report),
        planes_{coordinate_plane(mesh, patch, 0), coordinate_plane(mesh, patch, 1),
                coordinate_plane(mesh, patch, 2)} {}

  // How far the results lie beside the vertices, in cells: down, right.
  [[nodiscard]] std::array<double, 2> shift() const {
    return {to_double(y_plan(stencils_.limit, options_.boundary).misplacement()),
            to_double(x_plan(stencils_.limit, options_.boundary).misplacement())};
  }

  [[nodiscard]] Planes positions() const {
    if (options_.coordinates == Coordinates::all) return filtered(stencils_.limit, stencils_.limit);
    const Refiner<double> refiner(x_plan(stencils_.limit, options_.boundary),
                                  y_plan(stencils_.limit, options_.boundary), 0);
    const auto [down, right] = shift();
    return {shifted(planes_[0], patch_, down, right), shifted(planes_[1], patch_, down, right),
            refined_plane(refiner, planes_[2], report_, 30, 60)};
  }

  // Row by row; 0 where the derivatives vanish or are parallel (reflected rims of all coordinates).
  [[nodiscard]] std::vector<Point3> normals() const {
    const Planes east = filtered(*stencils_.derivative, stencils_.limit);
    const Planes south = filtered(stencils_.limit, *stencils_.derivative);
    const double least_east = 1e-9 * largest_length(east);
    const double least_south = 1e-9 * largest_length(south);
    const double side = patch_.mirrored ? -1 : 1;
    std::vector<Point3> result(patch_.vertices.size(), Point3{0, 0, 0});
    for (std::size_t i = 0; i < result.size(); ++i) {
      const Point3 a = vector_of(east, i);
      const Point3 b = vector_of(south, i);
      const Point3 n{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                     a[0] * b[1] - a[1] * b[0]};
      const double length = length_of(n);
      if (length_of(a) > least_east && length_of(b) > least_south &&
          length > 1e-9 * length_of(a) * length_of(b))
        result[i] = {side * n[0] / length, side * n[1] / length, side * n[2] / length};
    }
    return result;
  }

 private:
  static Point3 vector_of(const Planes& planes, std::size_t i) {
    return {planes[0].samples()[i], planes[1].samples()[i], planes[2].samples()[i]};
  }
  static double length_of(const Point3& v) { return std::hypot(v[0], v[1], v[2]); }
  static double largest_length(const Planes& planes) {
    double largest = 0;
    for (std::size_t i = 0; i < planes[0].samples().size(); ++i)
      largest = std::max(largest, length_of(vector_of(planes, i)));
    return largest;
  }

  [[nodiscard]] AxisPlan x_plan(const Stencil& stencil, Boundary boundary) const {
    return axis_plan(scheme_, patch_.extent.cols, patch_.wraps_cols, boundary, stencil);
  }
  [[nodiscard]] AxisPlan y_plan(const Stencil& stencil, Boundary boundary) const {
    return axis_plan(scheme_, patch_.extent.rows, patch_.wraps_rows, boundary, stencil);
  }
  [[nodiscard]] Planes filtered(const Stencil& along_rows, const Stencil& along_cols) const {
    Planes result;
    for (std::size_t k = 0; k < 3; ++k) {
      // x and y of a height field run on in straight lines whatever its heights do.
      const bool straight = options_.coordinates == Coordinates::heights && k < 2;
      const Boundary boundary = straight ? Boundary::extrapolate : options_.boundary;
      const Refiner<double> refiner(x_plan(along_rows, boundary), y_plan(along_cols, boundary), 0);
      result[k] = refined_plane(refiner, planes_[k], report_, 30, 60);
    }
    return result;
  }

  const GridPatch& patch_;
  const Scheme& scheme_;
  const LimitStencils& stencils_;
  const SubdivideOptions& options_;
  const Report& report_;
  Planes planes_;
};

void check_boundary(const GridPatch& patch, const SubdivideOptions& options) {
  if (patch.wraps_rows && patch.wraps_cols) return;
  if (options.boundary == Boundary::none)
    throw InvalidField("boundary none leaves the rim without limits; choose another boundary");
  if (options.boundary == Boundary::periodic && options.coordinates == Coordinates::all)
    throw InvalidField(
        "boundary periodic would bend x and y of an open rim to the other side; use "
        "it for heights only, or choose another boundary");
}

}  // namespace

MovedMesh moved_to_limit(const MeshArrays& mesh, const Scheme& scheme,
                         const SubdivideOptions& options, Report& report) {
  report.progress(0, "Finding the rows and columns of the mesh");
  const std::vector<GridPatch> patches = surface_patches(mesh, report);
  report.progress(20, "Computing limit stencils");
  const LimitStencils stencils = stencils_of(scheme);
  report.log("Scheme " + scheme.text());

  MovedMesh result;
  result.positions = mesh.positions;
  if (stencils.derivative) result.normals.assign(mesh.positions.size(), Point3{0, 0, 0});
  double largest_move = 0;
  std::size_t without = 0;
  for (const GridPatch& patch : patches) {
    check_boundary(patch, options);
    const LimitPatch limits(mesh, patch, scheme, stencils, options, report);
    const Planes planes = limits.positions();
    for (std::size_t i = 0; i < patch.vertices.size(); ++i) {
      Point3& p = result.positions[at(patch.vertices[i])];
      const Point3 old = p;
      p = {planes[0].samples()[i], planes[1].samples()[i], planes[2].samples()[i]};
      largest_move =
          std::max(largest_move, std::hypot(p[0] - old[0], p[1] - old[1], p[2] - old[2]));
    }
    if (stencils.derivative) {
      const std::vector<Point3> normals = limits.normals();
      for (std::size_t i = 0; i < normals.size(); ++i) {
        result.normals[at(patch.vertices[i])] = normals[i];
        if (normals[i] == Point3{0, 0, 0}) ++without;
      }
    }
    const auto [down, right] = limits.shift();
    if (down != 0 || right != 0)
      report.log("The limits of this scheme lie " + std::to_string(right) +
                 " of a cell beside the vertices along rows and " + std::to_string(down) +
                 " along columns; the vertices have moved there");
  }
  report.log("The largest move of a vertex is " + std::to_string(largest_move));
  if (!stencils.derivative)
    report.log("The scheme is not certified C^1, so normals are those of the faces");
  else
    report.log("Normals are those of the limit surface");
  if (without > 0)
    report.log("It has none at " + std::to_string(without) +
               " vertices, which keep those of their faces");
  return result;
}

}  // namespace arete::meshlab

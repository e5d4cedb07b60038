// SPDX-License-Identifier: MIT
#include "internal/surface_planes.h"

#include <limits>

namespace arete::vtk_filters {
namespace {

AxisPlan filtered(const Scheme& scheme, Index count, Boundary boundary, const Stencil& stencil,
                  Alignment alignment, FinalResult result) {
  return {scheme.mask(), count, AxisOptions{0, boundary, alignment, stencil, result}};
}

// A derivative of the ramp 0, 1, 2, ... is 1. Where limits are taken on the lattice of the next
// level (see AxisPlan), its samples are nearer to each other and the plan gives less.
double ramp_scale(const AxisPlan& derivative) {
  Rational of_ramp = 0;
  const auto& symbol = derivative.rules().back().symbol;
  for (int k = symbol.lowest(); k <= symbol.highest(); ++k) of_ramp -= k * symbol[k];
  return to_double(Rational(1 / of_ramp));
}

SurfaceAxis axis(const Scheme& scheme, Index count, Boundary boundary, bool limit,
                 bool limit_normals) {
  if (boundary == Boundary::none)
    throw InvalidField("boundary none leaves the rim without normals; choose another boundary");
  const AxisPlan samples = AxisPlan::identity(count);
  const auto height = [&] {
    return limit ? filtered(scheme, count, boundary, required_limit_of(scheme), Alignment::cells,
                            FinalResult::samples)
                 : samples;
  };
  if (limit_normals) {
    const AxisPlan derivative = filtered(scheme, count, boundary, *limit_of(scheme, 1),
                                         Alignment::cells, FinalResult::samples);
    return {height(),
            filtered(scheme, count, boundary, *limit_of(scheme, 0), Alignment::cells,
                     FinalResult::samples),
            derivative, ramp_scale(derivative)};
  }
  const Stencil central{-1, {Rational(-1, 2), 0, Rational(1, 2)}};
  return {height(), samples,
          filtered(scheme, count, boundary, central, Alignment::nodes, FinalResult::attribute), 1};
}

}  // namespace

SurfacePlans::SurfacePlans(const Settings& settings, bool limit, const VtkExtent& whole) {
  limit_normals = true;
  for (const Scheme* scheme : {&settings.x, &settings.y})
    limit_normals = limit_normals && limit_of(*scheme, 0) && limit_of(*scheme, 1);
  x = axis(settings.x, count_along(whole, 0), settings.boundaries.x, limit, limit_normals);
  y = axis(settings.y, count_along(whole, 1), settings.boundaries.y, limit, limit_normals);
}

StructuredPlan SurfacePlans::heights(const VtkExtent& whole) const {
  return {x.height, y.height, whole};
}
StructuredPlan SurfacePlans::along_x(const VtkExtent& whole) const {
  return {x.derivative, y.across, whole};
}
StructuredPlan SurfacePlans::along_y(const VtkExtent& whole) const {
  return {x.across, y.derivative, whole};
}

VtkExtent SurfacePlans::needed(const VtkExtent& whole, const VtkExtent& part) const {
  VtkExtent all = part;
  for (const StructuredPlan& plan : {heights(whole), along_x(whole), along_y(whole)}) {
    const VtkExtent one = StructuredPiece(plan, part).needed();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      all[2 * axis] = std::min(all[2 * axis], one[2 * axis]);
      all[2 * axis + 1] = std::max(all[2 * axis + 1], one[2 * axis + 1]);
    }
  }
  return all;
}

std::optional<SurfacePlanes> surface_planes(const SurfacePlans& plans, const VtkExtent& whole,
                                            const VtkExtent& part, vtkDataArray* heights,
                                            const HeldInput& held, int threads, Work& work) {
  const auto plane = [&](const StructuredPlan& plan, double scale) -> std::optional<Grid<double>> {
    const StructuredPiece piece(plan, part);
    const Refiner<double> refiner(piece.window().x.plan, piece.window().y.plan, threads);
    Grid<double> result(refiner.output());
    const bool finished =
        refine_in_bands<double>(refiner, read_plane<double>(heights, 0, part[4], piece, held), work,
                                [&](Index first, GridView<const double> band) {
                                  for (Index r = 0; r < band.rows(); ++r)
                                    for (Index c = 0; c < band.cols(); ++c)
                                      result(first + r, c) = band(r, c) * scale;
                                });
    if (!finished) return std::nullopt;
    return result;
  };
  auto height = plane(plans.heights(whole), 1);
  if (!height) return std::nullopt;
  auto by_x = plane(plans.along_x(whole), plans.x.scale);
  if (!by_x) return std::nullopt;
  auto by_y = plane(plans.along_y(whole), plans.y.scale);
  if (!by_y) return std::nullopt;
  return SurfacePlanes{std::move(*height), std::move(*by_x), std::move(*by_y)};
}

}  // namespace arete::vtk_filters

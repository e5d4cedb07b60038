// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/limit_frame.h"

#include <cmath>

#include "arete/analysis/limit_stencil.h"

namespace arete::openmesh::detail {
namespace {

AxisPlan with_stencil(const RefinedAxis& axis, const Scheme& scheme, int levels,
                      const Stencil& stencil) {
  AxisOptions options;
  options.levels = levels;
  options.boundary = axis.plan.boundary();
  options.final_stencil = stencil;
  return {scheme.mask(), axis.coarse(), options};
}

bool same_samples(const AxisPlan& a, const AxisPlan& b) {
  return a.output_count() == b.output_count() && a.first_position() == b.first_position();
}

}  // namespace

std::optional<LimitStencils> limit_stencils(const Scheme& scheme) {
  if (scheme.mask().tau() != 0) return std::nullopt;
  auto limit = limit_stencil(scheme.mask());
  auto derivative = derivative_stencil(scheme.mask());
  if (!limit || !derivative) return std::nullopt;
  return LimitStencils{std::move(*limit), std::move(*derivative)};
}

RebuildOptions rebuild_options(const Scheme& along_rows, const Scheme& along_cols,
                               Boundaries boundaries, int levels, bool on_limit) {
  RebuildOptions options{along_rows, along_cols, boundaries, levels};
  if (!on_limit) return options;
  const auto limit_of = [](const Scheme& scheme) {
    auto stencil = limit_stencil(scheme.mask());
    if (!stencil)
      throw InvalidField(scheme.text() +
                         " has no certified limit to put vertices on; choose a convergent scheme");
    return stencil;
  };
  options.final_along_rows = limit_of(along_rows);
  options.final_along_cols = limit_of(along_cols);
  return options;
}

bool limit_normals(const RefinedPatch& patch, const RebuildOptions& options,
                   const LimitStencils& along_rows, const LimitStencils& along_cols,
                   std::array<const Grid<double>*, 3> planes, int threads,
                   const std::function<void(Index, std::span<const std::array<double, 3>>)>& sink) {
  const auto x_plan = [&](const Stencil& stencil) {
    return with_stencil(patch.cols, options.along_rows, options.levels, stencil);
  };
  const auto y_plan = [&](const Stencil& stencil) {
    return with_stencil(patch.rows, options.along_cols, options.levels, stencil);
  };
  const Refiner<double> east(x_plan(along_rows.derivative), y_plan(along_cols.limit));
  const Refiner<double> south(x_plan(along_rows.limit), y_plan(along_cols.derivative));
  for (const Refiner<double>* refiner : {&east, &south})
    if (!same_samples(refiner->x(), patch.cols.plan) ||
        !same_samples(refiner->y(), patch.rows.plan))
      return false;

  const std::array<const Refiner<double>*, 6> refiners{&east, &east, &east, &south, &south, &south};
  const std::array<const Grid<double>*, 6> sources{planes[0], planes[1], planes[2],
                                                   planes[0], planes[1], planes[2]};
  const double side = patch.coarse.mirrored ? -1 : 1;
  refine_in_bands<double>(
      refiners, sources, threads, [&](Index r, std::span<const double* const> d) {
        std::vector<std::array<double, 3>> normals(static_cast<std::size_t>(patch.cols.fine()));
        for (Index c = 0; c < patch.cols.fine(); ++c) {
          std::array<double, 3>& n = normals[static_cast<std::size_t>(c)];
          n = {d[1][c] * d[5][c] - d[2][c] * d[4][c], d[2][c] * d[3][c] - d[0][c] * d[5][c],
               d[0][c] * d[4][c] - d[1][c] * d[3][c]};
          const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
          for (double& x : n) x = length > 0 ? side * x / length : 0;
        }
        sink(r, normals);
      });
  return true;
}

}  // namespace arete::openmesh::detail

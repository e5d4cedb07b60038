// SPDX-License-Identifier: MIT
#include "cli/curve_samples.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "arete/analysis/limit_stencil.h"
#include "arete/refine/refiner.h"
#include "cli/error.h"

namespace arete::cli {
namespace {

/// Filtered samples with their place on the last level.
struct Filtered {
  Grid<double> points;
  Rational first;
  Rational spacing;
};

Filtered filtered(const Grid<double>& control, const Scheme& scheme, const CurveRequest& request,
                  const std::optional<Stencil>& stencil) {
  AxisOptions options;
  options.levels = request.levels;
  options.boundary = request.boundary;
  options.final_stencil = stencil;
  AxisPlan along(scheme.mask(), control.rows(), options);
  const Rational first = along.first_position();
  const Rational spacing = along.spacing();
  const Refiner<double> refiner(AxisPlan::identity(control.cols()), std::move(along));
  return {refiner(control.view()), first, spacing};
}

Stencil stencil_of(const Scheme& scheme, int order, const char* option) {
  const auto stencil = derivative_stencil(scheme.mask(), order);
  if (!stencil)
    throw Misuse(std::string(option) + ": the limit of " + scheme.text() +
                 (order == 0 ? " is not certified to exist"
                             : " is not certified to be C^" + std::to_string(order)) +
                 "; leave the option out or choose a smoother scheme ('arete describe')");
  return *stencil;
}

// Without ghosts, wider stencils reach fewer samples: all are cut to those they have in common.
void cut_to_common(std::vector<Filtered*> parts) {
  Rational first = parts.front()->first;
  Rational last = first + Rational(parts.front()->points.rows() - 1) * parts.front()->spacing;
  for (const Filtered* part : parts) {
    first = std::max(first, part->first);
    last =
        std::min(last, Rational(part->first + Rational(part->points.rows() - 1) * part->spacing));
  }
  for (Filtered* part : parts) {
    const auto skip = static_cast<Index>(floor(Rational((first - part->first) / part->spacing)));
    const auto rows = static_cast<Index>(floor(Rational((last - first) / part->spacing))) + 1;
    if (rows < 1)
      throw InvalidField("boundary none leaves no point with a derivative; give more points");
    Grid<double> cut({rows, part->points.cols()});
    for (Index r = 0; r < rows; ++r)
      std::copy_n(part->points.row(r + skip), cut.cols(), cut.row(r));
    part->points = std::move(cut);
    part->first = first;
  }
}

void scale(Grid<double>& grid, double factor) {
  for (double& value : grid.samples()) value *= factor;
}

void fix_ends(const Grid<double>& control, CurveSamples& samples) {
  const double last = static_cast<double>(control.rows() - 1);
  const bool at_start = samples.tau.front() == 0;
  const bool at_end = samples.tau.back() == last;
  const Index before = at_start ? 0 : 1;
  const Index rows = samples.points.rows() + before + (at_end ? 0 : 1);
  // A derivative at an added point is that of its neighbour.
  const auto widened = [&](const Grid<double>& grid) {
    Grid<double> result({rows, grid.cols()});
    for (Index r = 0; r < rows; ++r)
      std::copy_n(grid.row(std::clamp<Index>(r - before, 0, grid.rows() - 1)), grid.cols(),
                  result.row(r));
    return result;
  };
  samples.points = widened(samples.points);
  std::copy_n(control.row(0), control.cols(), samples.points.row(0));
  std::copy_n(control.row(control.rows() - 1), control.cols(), samples.points.row(rows - 1));
  if (samples.tangents.rows() > 0) samples.tangents = widened(samples.tangents);
  const auto widen = [&](std::vector<double>& values, double front, double back) {
    if (!at_start) values.insert(values.begin(), front);
    if (!at_end) values.push_back(back);
  };
  if (!samples.curvature.empty())
    widen(samples.curvature, samples.curvature.front(), samples.curvature.back());
  widen(samples.tau, 0, last);
}

void check(const Grid<double>& control, const CurveRequest& request) {
  if (request.fixed_ends && request.boundary == Boundary::periodic)
    throw Misuse("--fixed-ends: a closed curve has no ends");
  if (request.fixed_ends && request.boundary == Boundary::none)
    throw Misuse(
        "--fixed-ends: with boundary none the curve does not come near its ends; choose "
        "another boundary");
  if (request.curvature && control.cols() < 2)
    throw Misuse("--curvature: points of one coordinate are not a curve in space");
}

}  // namespace

CurveSamples sample_curve(const Grid<double>& control, const Scheme& scheme,
                          const CurveRequest& request) {
  check(control, request);
  const bool derivatives = request.tangents || request.curvature;
  std::optional<Stencil> limit;
  if (request.limit || derivatives)
    limit = stencil_of(scheme, 0, request.limit ? "--limit" : "--tangents");
  Filtered points = filtered(control, scheme, request, limit);
  Filtered first, second;
  std::vector<Filtered*> parts{&points};
  if (derivatives) {
    const char* option = request.tangents ? "--tangents" : "--curvature";
    first = filtered(control, scheme, request, stencil_of(scheme, 1, option));
    parts.push_back(&first);
  }
  if (request.curvature) {
    second = filtered(control, scheme, request, stencil_of(scheme, 2, "--curvature"));
    parts.push_back(&second);
  }
  cut_to_common(parts);

  const double per_unit = 1 / to_double(points.spacing);
  scale(first.points, per_unit);
  scale(second.points, per_unit * per_unit);
  CurveSamples samples;
  if (request.curvature) samples.curvature = curvature_of(first.points, second.points);
  if (request.tangents) samples.tangents = std::move(first.points);
  for (Index r = 0; r < points.points.rows(); ++r)
    samples.tau.push_back(to_double(Rational(points.first + Rational(r) * points.spacing)));
  samples.points = std::move(points.points);
  if (request.fixed_ends) fix_ends(control, samples);
  return samples;
}

std::vector<double> curvature_of(const Grid<double>& first, const Grid<double>& second) {
  std::vector<double> result;
  for (Index r = 0; r < first.rows(); ++r) {
    double aa = 0, ab = 0, bb = 0;
    for (Index c = 0; c < first.cols(); ++c) {
      aa += first(r, c) * first(r, c);
      ab += first(r, c) * second(r, c);
      bb += second(r, c) * second(r, c);
    }
    const double area = first.cols() == 2 ? first(r, 0) * second(r, 1) - first(r, 1) * second(r, 0)
                                          : std::sqrt(std::max(0.0, aa * bb - ab * ab));
    result.push_back(aa > 0 ? area / (aa * std::sqrt(aa))
                            : std::numeric_limits<double>::quiet_NaN());
  }
  return result;
}

}  // namespace arete::cli

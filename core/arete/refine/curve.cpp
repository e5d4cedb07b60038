// SPDX-License-Identifier: MIT
#include "arete/refine/curve.h"

namespace arete {

template <class T>
Curve<T> refine_curve(GridView<const T> points, const Scheme& scheme, const CurveOptions& options) {
  if (points.rows() < 1 || points.cols() < 1)
    throw InvalidField("a curve needs at least one point with at least one coordinate");
  const Boundary boundary = options.closed ? Boundary::periodic : options.boundary;
  AxisPlan along(scheme.mask(), points.rows(),
                 {options.levels, boundary, Alignment::nodes, {}, {}});
  const AxisPlacement parameter = along.placement();
  const Refiner<T> refiner(AxisPlan::identity(points.cols()), std::move(along));
  return {refiner(points), parameter};
}

template Curve<float> refine_curve(GridView<const float>, const Scheme&, const CurveOptions&);
template Curve<double> refine_curve(GridView<const double>, const Scheme&, const CurveOptions&);

}  // namespace arete

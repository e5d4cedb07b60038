// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "internal/plane.h"
#include "internal/settings.h"

namespace arete::vtk_filters {

/// One axis of a height image, as a surface needs it: one result per sample.
struct SurfaceAxis {
  AxisPlan height = AxisPlan::identity(1);  ///< the samples, or limits
  AxisPlan across =
      AxisPlan::identity(1);  ///< what goes along with the derivative along the other axis
  AxisPlan derivative = AxisPlan::identity(1);  ///< by the sample index, up to `scale`
  double scale = 1;
};

/// The heights of a surface and their derivatives, all from one image.
struct SurfacePlans {
  SurfaceAxis x;
  SurfaceAxis y;
  bool limit_normals = false;

  /// \throws InvalidScheme if `limit` is asked for and there is none; InvalidField for boundary
  /// none, which leaves the rim without derivatives.
  SurfacePlans(const Settings& settings, bool limit, const VtkExtent& whole);

  [[nodiscard]] StructuredPlan heights(const VtkExtent& whole) const;
  [[nodiscard]] StructuredPlan along_x(const VtkExtent& whole) const;
  [[nodiscard]] StructuredPlan along_y(const VtkExtent& whole) const;
  /// What all three read for a part of the surface.
  [[nodiscard]] VtkExtent needed(const VtkExtent& whole, const VtkExtent& part) const;
};

/// A part of a surface, row by row; NaN where heights are missing.
struct SurfacePlanes {
  Grid<double> height;
  Grid<double> by_x;  ///< derivatives by the sample index
  Grid<double> by_y;
};

/// Nothing if aborted.
[[nodiscard]] std::optional<SurfacePlanes> surface_planes(
    const SurfacePlans& plans, const VtkExtent& whole, const VtkExtent& part, vtkDataArray* heights,
    const HeldInput& held, int threads, Work& work);

}  // namespace arete::vtk_filters

// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "arete/gdal/geotiff.h"
#include "arete/refine/refiner.h"
#include "arete/scheme/stencil.h"

namespace arete::gdal {

/// The limit's weights at a sample, along x and along y.
struct LimitWeights {
  Stencil x;
  Stencil y;
};

/// How the refined raster is written.
struct RasterOutput {
  SampleType type = SampleType::float32;  ///< sums are taken in this type
  std::vector<std::string> creation_options;
  double max_memory = 1e9;  ///< bytes the refinement may hold at a time
  /// Refine not the input but the control points whose limit passes through it (CardinalSource).
  std::optional<LimitWeights> interpolate{};
};

/// What refine_raster did.
struct RasterReport {
  Extent input;
  Extent output;
  int bands = 0;
  double misplacement_x = 0;  ///< see AxisPlan::misplacement, in samples of the input
  double misplacement_y = 0;
};

/// Told the share done, 0..1, from time to time; may throw to stop the work.
using Progress = std::function<void(double)>;

/// Refines every band of a raster into a GeoTIFF at `output`, band of rows by band of rows: memory
/// grows with the width of the result, never with its height. CRS, geotransform (rotated ones too),
/// control points, AREA_OR_POINT, nodata, scale, offset, unit, description and metadata are
/// carried.
///
/// Missing samples become the input's nodata value, or NaN when it has none; a valid result that
/// happens to equal the nodata value is moved to the next number towards zero.
/// With `interpolate` missing samples are refused: they have no control points.
/// \throws RasterError, InvalidField; the file at `output` is then not usable and should be
/// removed.
RasterReport refine_raster(const Raster& input, const std::string& output, const Scheme& x,
                           const Scheme& y, const RefineOptions& options, const RasterOutput& form,
                           const Progress& progress);

/// The georeference and everything else of a raster refined into `extent`, for a GeoTIFF.
[[nodiscard]] GeoTiffSpec refined_spec(const Raster& input, const AxisPlan& x, const AxisPlan& y,
                                       const RasterOutput& form, int threads);

}  // namespace arete::gdal

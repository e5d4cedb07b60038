// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "arete/gdal/refine_raster.h"
#include "cli/progress.h"

namespace arete::cli {

/// One band of a raster refined in memory and written for VTK: .vti (heights), .vts or .vtp
/// (geometry with normals from the limit tangents where both schemes are certified C^1, from
/// central differences otherwise; the field data say which).
/// `interpolate`: of the control points whose limit passes through the samples.
/// `form` is one of ".vti", ".vts", ".vtp". \throws Failure if it would take more than max_memory.
gdal::RasterReport refine_to_surface(const gdal::Raster& input, int band,
                                     const std::filesystem::path& output, const std::string& form,
                                     const Scheme& x, const Scheme& y, const RefineOptions& options,
                                     gdal::SampleType type, double max_memory,
                                     const std::optional<gdal::LimitWeights>& interpolate,
                                     ProgressBar& progress);

}  // namespace arete::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>

#include "arete/gdal/refine_raster.h"
#include "arete/vtk/appearance.h"
#include "cli/detail_statistics.h"
#include "cli/progress.h"

namespace arete::cli {

/// What a textured model looks like.
struct ModelLook {
  vtk::Appearance appearance{};
  std::string texture;  ///< a picture to drape over it; none if empty
};

struct RefinedSurface {
  gdal::RasterReport raster;
  DetailStatistics detail;  ///< if there is any detail
};

/// One band of a raster refined in memory and written for VTK: .vti (heights), .vts or .vtp
/// (geometry with normals from the limit tangents where both schemes are certified C^1, from
/// central differences otherwise; the field data say which), or as a textured model (.glb), whose
/// normals are the same.
/// `interpolate`: of the control points whose limit passes through the samples.
/// `form` is one of ".vti", ".vts", ".vtp", ".glb". \throws Failure if it would take more than
/// max_memory.
RefinedSurface refine_to_surface(const gdal::Raster& input, int band,
                                 const std::filesystem::path& output, const std::string& form,
                                 const Scheme& x, const Scheme& y, const RefineOptions& options,
                                 gdal::SampleType type, double max_memory, const ModelLook& look,
                                 const std::optional<gdal::LimitWeights>& interpolate,
                                 ProgressBar& progress);

}  // namespace arete::cli

// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "arete/gdal/geotiff.h"
#include "arete/reverse/missing_samples.h"

namespace arete::cli {

/// What a details file remembers of the raster it was taken from, beside sizes: enough to write
/// the same raster again.
struct RasterNotes {
  std::optional<Georeference> georeference;
  std::optional<double> nodata;
  bool integers = false;  ///< every band held whole numbers
  bool needs_float64 = false;

  [[nodiscard]] static RasterNotes of(const gdal::Raster& raster);
  /// One JSON object, as text. parse() throws Failure for any other text.
  [[nodiscard]] std::string text() const;
  [[nodiscard]] static RasterNotes parse(const std::string& text);
};

/// Everything of `raster` but its size and place, for a GeoTIFF of other samples.
[[nodiscard]] gdal::GeoTiffSpec spec_like(const gdal::Raster& raster, Extent extent,
                                          gdal::SampleType type);

/// Where the rows and columns of a level lie among those of the input.
struct LevelPlace {
  AxisPlacement rows;
  AxisPlacement cols;
  [[nodiscard]] static LevelPlace of(const GridPyramid& pyramid, int step) {
    return {pyramid.row_placement(step), pyramid.col_placement(step)};
  }
};

/// Carries the raster's ground control points from the pixels of one level to those of another.
void carry_control_points(const gdal::Raster& raster, const LevelPlace& from, const LevelPlace& to,
                          gdal::GeoTiffSpec& spec);

/// Writes the bands, one grid each, missing samples as spec.nodata says (NaN if it says nothing);
/// a valid sample that equals nodata is moved to the next number towards zero.
/// `valid` has one entry a band. \throws gdal::RasterError
void write_bands(const std::filesystem::path& path, gdal::GeoTiffSpec spec,
                 const std::vector<Grid<double>>& bands, const std::vector<ValidSamples>& valid);

}  // namespace arete::cli

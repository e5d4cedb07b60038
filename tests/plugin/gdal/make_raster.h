// SPDX-License-Identifier: MIT
#pragma once

#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "arete/field/grid.h"
#include "arete/gdal/raster.h"

namespace arete::test {

/// What a raster for a test shall be.
struct RasterSpec {
  Extent extent{12, 16};
  GDALDataType type = GDT_Float64;
  std::array<double, 6> affine{500000, 32, 0, 4000000, 0, -32};
  std::string crs = "EPSG:32616";
  std::optional<double> nodata;
  bool point = false;
  int bands = 1;
  std::vector<const char*> options;
  const char* driver = "GTiff";
};

using DatasetPointer = std::unique_ptr<GDALDataset, decltype(&GDALClose)>;

/// Creates it with height(band, row, col), band from 1; returned open for further touches.
inline DatasetPointer make_raster(const std::string& path, const RasterSpec& spec,
                                  const std::function<double(int, Index, Index)>& height) {
  gdal::register_formats();
  std::vector<const char*> options = spec.options;
  options.push_back(nullptr);
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName(spec.driver);
  DatasetPointer dataset(driver->Create(path.c_str(), static_cast<int>(spec.extent.cols),
                                        static_cast<int>(spec.extent.rows), spec.bands, spec.type,
                                        const_cast<char**>(options.data())),
                         &GDALClose);
  dataset->SetMetadataItem(GDALMD_AREA_OR_POINT, spec.point ? GDALMD_AOP_POINT : GDALMD_AOP_AREA);
  auto affine = spec.affine;
  dataset->SetGeoTransform(affine.data());
  if (!spec.crs.empty()) {
    OGRSpatialReference reference;
    reference.SetFromUserInput(spec.crs.c_str());
    reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    dataset->SetSpatialRef(&reference);
  }
  std::vector<double> row(static_cast<std::size_t>(spec.extent.cols));
  for (int band = 1; band <= spec.bands; ++band) {
    GDALRasterBand* target = dataset->GetRasterBand(band);
    if (spec.nodata) target->SetNoDataValue(*spec.nodata);
    for (Index r = 0; r < spec.extent.rows; ++r) {
      for (Index c = 0; c < spec.extent.cols; ++c)
        row[static_cast<std::size_t>(c)] = height(band, r, c);
      if (target->RasterIO(GF_Write, 0, static_cast<int>(r), static_cast<int>(spec.extent.cols), 1,
                           row.data(), static_cast<int>(spec.extent.cols), 1, GDT_Float64, 0, 0,
                           nullptr) != CE_None)
        throw std::runtime_error("cannot make " + path);
    }
  }
  return dataset;
}

}  // namespace arete::test

// SPDX-License-Identifier: MIT
#include "arete/gdal/raster.h"

#include <cpl_conv.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <algorithm>
#include <mutex>

#include "arete/gdal/reference_system.h"
#include "arete/gdal/remote.h"

namespace arete::gdal {
namespace {

Metadata to_metadata(char** list) {
  Metadata metadata;
  for (char** item = list; item != nullptr && *item != nullptr; ++item) {
    char* key = nullptr;
    const char* value = CPLParseNameValue(*item, &key);
    // Statistics are those of the samples before refinement.
    if (key != nullptr && value != nullptr && !STARTS_WITH_CI(key, "STATISTICS_"))
      metadata.emplace_back(key, value);
    CPLFree(key);
  }
  return metadata;
}

// Grids as text, one driver under three names.
bool is_text_grid(GDALDataset& dataset) {
  const GDALDriver* driver = dataset.GetDriver();
  const std::string name = driver != nullptr ? driver->GetDescription() : "";
  return name == "AAIGrid" || name == "GRASSASCIIGrid" || name == "ISG";
}

}  // namespace

void register_formats() {
  static std::once_flag once;
  std::call_once(once, [] { GDALAllRegister(); });
}

void limit_cache(double bytes) { GDALSetCacheMax64(static_cast<GIntBig>(bytes)); }

void Raster::Close::operator()(GDALDataset* dataset) const { GDALClose(dataset); }

Raster::Raster(const std::string& path) : path_(path) {
  refuse_remote(path);
  register_formats();
  const ErrorCollector errors;
  VSIStatBufL status;
  const bool exists = VSIStatL(path.c_str(), &status) == 0;
  dataset_.reset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY));
  if (!dataset_) {
    if (!exists) throw RasterError(path + " does not exist or cannot be read; check the path");
    const std::string reason = errors.failed() ? " (GDAL: " + errors.message() + ")" : "";
    throw RasterError(path + " is not a raster that GDAL can read" + reason +
                      "; give a GeoTIFF or another raster that 'gdalinfo' opens");
  }
  extent_ = {dataset_->GetRasterYSize(), dataset_->GetRasterXSize()};
  rows_follow_each_other_ = is_text_grid(*dataset_);
  read_bands();
  check_claims();
  read_reference();
  metadata_ = to_metadata(dataset_->GetMetadata());
}

Georeference Raster::place() const {
  return georeference_.value_or(Georeference{{-0.5, 1, 0, 0.5, 0, -1}, Registration::area});
}

void Raster::read_bands() {
  int alpha = 0;
  for (int number = 1; number <= dataset_->GetRasterCount(); ++number) {
    GDALRasterBand* band = dataset_->GetRasterBand(number);
    const std::string where = path_ + ", band " + std::to_string(number);
    const GDALDataType type = band->GetRasterDataType();
    if (band->GetColorInterpretation() == GCI_AlphaBand) {
      alpha = number;
      continue;
    }
    if (GDALDataTypeIsComplex(type) != 0)
      throw RasterError(where + " holds complex numbers (" + GDALGetDataTypeName(type) +
                        "); extract a real part first, e.g. with gdal_calc.py");
    if (band->GetColorTable() != nullptr)
      throw RasterError(where +
                        " holds palette indices, which cannot be interpolated; expand it "
                        "first with gdal_translate -expand rgb");
    BandInfo info;
    info.number = number;
    info.type = GDALGetDataTypeName(type);
    info.floating = GDALDataTypeIsFloating(type) != 0;
    info.masked = (band->GetMaskFlags() & GMF_ALL_VALID) == 0;
    int has = 0;
    const double nodata = band->GetNoDataValue(&has);
    if (has != 0) info.nodata = nodata;
    const double scale = band->GetScale(&has);
    if (has != 0) info.scale = scale;
    const double offset = band->GetOffset(&has);
    if (has != 0) info.offset = offset;
    info.unit = band->GetUnitType();
    info.description = band->GetDescription();
    info.color_interpretation = band->GetColorInterpretation();
    info.metadata = to_metadata(band->GetMetadata());
    bands_.push_back(std::move(info));
  }
  for (BandInfo& band : bands_)
    if (!band.masked) band.alpha_band = alpha;
  if (!bands_.empty()) return;
  const char* subdataset = dataset_->GetMetadataItem("SUBDATASET_1_NAME", "SUBDATASETS");
  throw RasterError(path_ + " has no data band" +
                    (subdataset != nullptr
                         ? "; name one of its subdatasets, e.g. " + std::string(subdataset)
                         : "; give a raster with heights"));
}

void Raster::check_claims() {
  for (int number = 1; number <= dataset_->GetRasterCount(); ++number) {
    GDALRasterBand* band = dataset_->GetRasterBand(number);
    int width = 0, height = 0;
    band->GetBlockSize(&width, &height);
    const double bytes =
        static_cast<double>(width) * height * GDALGetDataTypeSizeBytes(band->GetRasterDataType());
    block_bytes_ = std::max(block_bytes_, bytes);
  }
  // A few rows of doubles are the least that anything done with a raster holds.
  const double rows = 4.0 * sizeof(double) * static_cast<double>(extent_.cols);
  const double allowed = 0.5 * static_cast<double>(CPLGetUsablePhysicalRAM());
  const auto refuse = [&](const std::string& what, double bytes, const std::string& remedy) {
    if (allowed > 0 && bytes > allowed)
      throw RasterError(path_ + " (" + std::to_string(extent_.cols) + " x " +
                        std::to_string(extent_.rows) + ") " + what + " " +
                        std::to_string(static_cast<long long>(bytes / 1e6)) +
                        " MB, more than half of this machine's memory; " + remedy);
  };
  refuse("has rows of which four take", rows, "cut out a part with gdal_translate -srcwin");
  refuse("is stored in blocks that take", block_bytes_,
         "rewrite it with gdal_translate -co TILED=YES");
}

void Raster::read_reference() {
  std::array<double, 6> affine{};
  if (dataset_->GetGeoTransform(affine.data()) == CE_None) {
    const char* kind = dataset_->GetMetadataItem(GDALMD_AREA_OR_POINT);
    const bool point = kind != nullptr && EQUAL(kind, GDALMD_AOP_POINT);
    georeference_ = Georeference{affine, point ? Registration::point : Registration::area};
  }
  if (const OGRSpatialReference* reference = dataset_->GetSpatialRef()) {
    crs_ = wkt_of(reference);
    geographic_ = reference->IsGeographic() != 0;
  }
  const GDAL_GCP* points = dataset_->GetGCPs();
  for (int i = 0; i < dataset_->GetGCPCount(); ++i)
    control_points_.push_back({points[i].pszId, points[i].pszInfo, points[i].dfGCPPixel,
                               points[i].dfGCPLine, points[i].dfGCPX, points[i].dfGCPY,
                               points[i].dfGCPZ});
  control_point_crs_ = wkt_of(dataset_->GetGCPSpatialRef());
}

}  // namespace arete::gdal

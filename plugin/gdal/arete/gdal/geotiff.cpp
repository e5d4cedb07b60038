// SPDX-License-Identifier: MIT
#include "arete/gdal/geotiff.h"

#include <sys/resource.h>

#include <cpl_string.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <limits>
#include <new>
#include <string_view>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>

namespace arete::gdal {
namespace {

// Whether GDAL's threads will start: it would wait for ever for one that did not. Under a limit on
// memory nobody can know.
bool threads_are_certain() {
  rlimit memory{};
  if (getrlimit(RLIMIT_AS, &memory) == 0 && memory.rlim_cur != RLIM_INFINITY) return false;
  try {
    std::thread([] {}).join();
    return true;
  } catch (const std::system_error&) {
    return false;
  }
}

// The user's options and those defaults that they do not contradict.
CPLStringList creation_options(const GeoTiffSpec& spec) {
  CPLStringList options;
  for (const std::string& option : spec.creation_options) {
    if (option.find('=') == std::string::npos)
      throw RasterError("creation option '" + option + "' is not KEY=VALUE, e.g. COMPRESS=ZSTD");
    options.AddString(option.c_str());
  }
  const auto default_to = [&](const char* key, const char* value) {
    if (options.FetchNameValue(key) == nullptr) options.SetNameValue(key, value);
  };
  default_to("TILED", "YES");
  default_to("COMPRESS", "DEFLATE");
  default_to("BIGTIFF", "IF_SAFER");
  default_to("INTERLEAVE", "BAND");
  const char* compression = options.FetchNameValue("COMPRESS");
  if (EQUAL(compression, "DEFLATE") || EQUAL(compression, "ZSTD") || EQUAL(compression, "LZW"))
    default_to("PREDICTOR", "3");
  if (!EQUAL(compression, "NONE") && threads_are_certain())
    default_to("NUM_THREADS", spec.threads > 0 ? std::to_string(spec.threads).c_str() : "ALL_CPUS");
  return options;
}

OGRSpatialReference reference_from(const std::string& wkt) {
  OGRSpatialReference reference;
  reference.importFromWkt(wkt.c_str());
  // GDAL's own default order for rasters: x before y.
  reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  return reference;
}

void set_reference(GDALDataset& dataset, const GeoTiffSpec& spec) {
  for (const auto& [key, value] : spec.metadata)
    dataset.SetMetadataItem(key.c_str(), value.c_str());
  if (spec.georeference) {
    auto affine = spec.georeference->affine;
    dataset.SetMetadataItem(GDALMD_AREA_OR_POINT,
                            spec.georeference->registration == Registration::point
                                ? GDALMD_AOP_POINT
                                : GDALMD_AOP_AREA);
    dataset.SetGeoTransform(affine.data());
  }
  if (!spec.crs.empty()) {
    const OGRSpatialReference reference = reference_from(spec.crs);
    dataset.SetSpatialRef(&reference);
  }
  if (!spec.control_points.empty()) {
    std::vector<GDAL_GCP> points;
    for (const ControlPoint& p : spec.control_points)
      points.push_back({const_cast<char*>(p.id.c_str()), const_cast<char*>(p.info.c_str()), p.pixel,
                        p.line, p.x, p.y, p.z});
    const OGRSpatialReference reference = reference_from(spec.control_point_crs);
    dataset.SetGCPs(static_cast<int>(points.size()), points.data(),
                    spec.control_point_crs.empty() ? nullptr : &reference);
  }
}

void set_band(GDALRasterBand& band, const BandInfo& info, const std::optional<double>& nodata) {
  if (nodata) band.SetNoDataValue(*nodata);
  if (info.scale) band.SetScale(*info.scale);
  if (info.offset) band.SetOffset(*info.offset);
  if (!info.unit.empty()) band.SetUnitType(info.unit.c_str());
  if (!info.description.empty()) band.SetDescription(info.description.c_str());
  band.SetColorInterpretation(static_cast<GDALColorInterp>(info.color_interpretation));
  for (const auto& [key, value] : info.metadata) band.SetMetadataItem(key.c_str(), value.c_str());
}

// Whether bytes of every block stand in the file.
bool has_all_blocks(GDALDataset& dataset) {
  for (int number = 1; number <= dataset.GetRasterCount(); ++number) {
    GDALRasterBand* band = dataset.GetRasterBand(number);
    int width = 0, height = 0;
    band->GetBlockSize(&width, &height);
    const int across = (dataset.GetRasterXSize() - 1) / width;
    const int down = (dataset.GetRasterYSize() - 1) / height;
    for (int y = 0; y <= down; ++y)
      for (int x = 0; x <= across; ++x) {
        const std::string key = "BLOCK_SIZE_" + std::to_string(x) + "_" + std::to_string(y);
        const char* size = band->GetMetadataItem(key.c_str(), "TIFF");
        if (size == nullptr || std::string_view(size) == "0") return false;
      }
  }
  return true;
}

// GDAL's threads that compress have nobody to tell that they failed.
void check_blocks(const std::string& path) {
  const ErrorCollector errors;
  GDALDataset* dataset = GDALDataset::Open(path.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY);
  const bool whole = dataset != nullptr && has_all_blocks(*dataset);
  if (dataset != nullptr) GDALClose(dataset);
  if (!whole)
    throw RasterError(path +
                      " is incomplete: GDAL could not compress all of it; free some memory, "
                      "or use --creation-option NUM_THREADS=1");
}

}  // namespace

struct GeoTiffWriter::State {
  std::string path;
  bool threads = false;  ///< GDAL compresses in threads of its own
  /// GDAL was left by an exception (memory ran out), perhaps with its locks held: to touch the
  /// dataset again, even to close it, could wait for ever.
  bool lost = false;
  GDALDataset* dataset = nullptr;
  ErrorCollector errors;

  State() = default;
  ~State() {
    if (dataset == nullptr || lost) return;
    try {
      GDALClose(dataset);
    } catch (const std::bad_alloc&) {  // the file is not complete, and nobody was told it is
    }
  }
  State(const State&) = delete;
  State& operator=(const State&) = delete;

  [[noreturn]] void fail(const ErrorCollector& why) const {
    const std::string words = why.message();
    const bool memory = words.find("llocat") != std::string::npos;
    throw RasterError(
        path + " cannot be written (GDAL: " + words + "); " +
        (memory ? "free some memory or use fewer levels" : "check free space and permissions"));
  }
  [[noreturn]] void fail() const { fail(errors); }
};

GeoTiffWriter::GeoTiffWriter(const std::string& path, const GeoTiffSpec& spec)
    : state_(std::make_unique<State>()) {
  register_formats();
  state_->path = path;
  constexpr Index largest = std::numeric_limits<int>::max();
  if (spec.extent.rows > largest || spec.extent.cols > largest)
    throw RasterError("a raster of " + std::to_string(spec.extent.cols) + " x " +
                      std::to_string(spec.extent.rows) +
                      " samples is beyond GeoTIFF's 2^31 - 1 a side; use fewer levels or tiles");
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  const CPLStringList options = creation_options(spec);
  if (GDALValidateCreationOptions(driver, options.List()) == 0)
    throw RasterError("a creation option is not one of GeoTIFF's; see 'gdalinfo --format GTiff'");
  const GDALDataType type = spec.type == SampleType::float32 ? GDT_Float32 : GDT_Float64;
  state_->threads =
      options.FetchNameValue("NUM_THREADS") != nullptr && !options.FetchBool("SPARSE_OK", false);
  state_->dataset = driver->Create(path.c_str(), static_cast<int>(spec.extent.cols),
                                   static_cast<int>(spec.extent.rows),
                                   static_cast<int>(spec.bands.size()), type, options.List());
  if (state_->dataset == nullptr) state_->fail();
  set_reference(*state_->dataset, spec);
  for (std::size_t i = 0; i < spec.bands.size(); ++i)
    set_band(*state_->dataset->GetRasterBand(static_cast<int>(i) + 1), spec.bands[i], spec.nodata);
  // The header is written while there is memory. Short of it, GDAL would put the reference system
  // into a file of its own, without a word.
  state_->lost = true;
  state_->dataset->FlushCache();
  state_->lost = false;
  if (state_->errors.failed()) state_->fail();
}

GeoTiffWriter::~GeoTiffWriter() = default;

Index GeoTiffWriter::block_rows() const {
  int width = 0;
  int height = 0;
  state_->dataset->GetRasterBand(1)->GetBlockSize(&width, &height);
  return height;
}

template <class T>
void GeoTiffWriter::write(int band, Index first_row, GridView<const T> rows) {
  constexpr GDALDataType type = std::is_same_v<T, float> ? GDT_Float32 : GDT_Float64;
  // The thread that writes need not be the one that the writer was made in.
  const ErrorCollector errors;
  state_->lost = true;
  const auto status = state_->dataset->GetRasterBand(band)->RasterIO(
      GF_Write, 0, static_cast<int>(first_row), static_cast<int>(rows.cols()),
      static_cast<int>(rows.rows()), const_cast<T*>(rows.row(0)), static_cast<int>(rows.cols()),
      static_cast<int>(rows.rows()), type, sizeof(T),
      static_cast<GSpacing>(rows.stride()) * static_cast<GSpacing>(sizeof(T)), nullptr);
  state_->lost = false;
  if (status != CE_None || errors.failed()) state_->fail(errors);
}

void GeoTiffWriter::close() {
  GDALClose(std::exchange(state_->dataset, nullptr));
  if (state_->errors.failed()) state_->fail();
  if (state_->threads) check_blocks(state_->path);
}

template void GeoTiffWriter::write(int, Index, GridView<const float>);
template void GeoTiffWriter::write(int, Index, GridView<const double>);

}  // namespace arete::gdal

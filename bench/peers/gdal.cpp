// SPDX-License-Identifier: MIT
#include <gdal_priv.h>
#include <gdal_utils.h>

#include <cstdlib>
#include <memory>

#include "peer.h"

namespace arete::bench {
namespace {

using Dataset = std::shared_ptr<GDALDataset>;

Dataset in_memory(const Job& job) {
  GDALAllRegister();
  const auto cols = static_cast<int>(job.heights.cols());
  const auto rows = static_cast<int>(job.heights.rows());
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  Dataset dataset(driver->Create("", cols, rows, 1, GDT_Float32, nullptr),
                  [](GDALDataset* d) { GDALClose(d); });
  double affine[6]{0, 1, 0, 0, 0, -1};
  dataset->SetGeoTransform(affine);
  const CPLErr status = dataset->GetRasterBand(1)->RasterIO(
      GF_Write, 0, 0, cols, rows, const_cast<float*>(job.heights.samples().data()), cols, rows,
      GDT_Float32, 0, 0, nullptr);
  if (status != CE_None) std::abort();
  return dataset;
}

Run raster_io(const Job& job) {
  const Dataset input = in_memory(job);
  const Extent size{job.heights.rows() << job.levels, job.heights.cols() << job.levels};
  auto result = std::make_shared<std::vector<float>>(static_cast<std::size_t>(size.rows) *
                                                     static_cast<std::size_t>(size.cols));
  return {[=] {
            GDALRasterIOExtraArg how;
            INIT_RASTERIO_EXTRA_ARG(how);
            how.eResampleAlg = GRIORA_CubicSpline;
            const CPLErr status = input->GetRasterBand(1)->RasterIO(
                GF_Read, 0, 0, input->GetRasterXSize(), input->GetRasterYSize(), result->data(),
                static_cast<int>(size.cols), static_cast<int>(size.rows), GDT_Float32, 0, 0, &how);
            if (status != CE_None) std::abort();
          },
          {}};
}

Run warp(const Job& job, const char* kernel) {
  const Dataset input = in_memory(job);
  const std::string cols = std::to_string(job.heights.cols() << job.levels);
  const std::string rows = std::to_string(job.heights.rows() << job.levels);
  return {[=] {
            const char* arguments[]{"-of",        "MEM", "-ts",  cols.c_str(),
                                    rows.c_str(), "-r",  kernel, nullptr};
            GDALWarpAppOptions* options =
                GDALWarpAppOptionsNew(const_cast<char**>(arguments), nullptr);
            GDALDatasetH from = input.get();
            GDALDatasetH result = GDALWarp("", nullptr, 1, &from, options, nullptr);
            GDALWarpAppOptionsFree(options);
            GDALClose(result);
          },
          {}};
}

}  // namespace

std::vector<Peer> gdal_peers() {
  return {{"GDAL, RasterIO cubicspline", false, false, 10, 5, raster_io},
          {"GDAL, Warp cubic, MEM to MEM", false, true, 80, 2,
           [](const Job& job) { return warp(job, "cubic"); }},
          {"GDAL, Warp cubicspline, MEM to MEM", false, true, 300, 1,
           [](const Job& job) { return warp(job, "cubicspline"); }}};
}

}  // namespace arete::bench

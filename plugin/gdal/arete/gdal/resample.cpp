// SPDX-License-Identifier: MIT
#include "arete/gdal/resample.h"

#include <gdal_priv.h>
#include <gdal_utils.h>

#include <charconv>
#include <limits>
#include <memory>

#include "arete/gdal/internal/dataset.h"
#include "arete/gdal/raster.h"

namespace arete::gdal {
namespace {

// The field as a raster of 1 x 1 pixels in memory.
Dataset in_memory(GridView<const double> field) {
  const auto cols = static_cast<int>(field.cols());
  const auto rows = static_cast<int>(field.rows());
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  Dataset dataset(driver->Create("", cols, rows, 1, GDT_Float64, nullptr));
  double affine[6]{0, 1, 0, 0, 0, -1};
  if (!dataset || dataset->SetGeoTransform(affine) != CE_None) return nullptr;
  GDALRasterBand* band = dataset->GetRasterBand(1);
  band->SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  if (band->RasterIO(GF_Write, 0, 0, cols, rows, const_cast<double*>(field.row(0)), cols, rows,
                     GDT_Float64, 0, static_cast<GSpacing>(field.stride()) * 8, nullptr) != CE_None)
    return nullptr;
  return dataset;
}

// The shortest text that reads back as the same number.
std::string exact_text(double value) {
  char text[64];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

}  // namespace

Grid<double> resampled(GridView<const double> field, const std::string& kernel, int factor) {
  register_formats();
  const ErrorCollector errors;
  const Index cols = factor * (field.cols() - 1) + 1;
  const Index rows = factor * (field.rows() - 1) + 1;
  constexpr Index largest = std::numeric_limits<int>::max();
  if (cols > largest || rows > largest)
    throw RasterError("a raster of more than 2^31 - 1 samples a side is beyond GDAL's");
  const Dataset source = in_memory(field);
  const double pixel = 1.0 / factor;
  const double edge = 0.5 - pixel / 2;
  const std::string extent[]{
      exact_text(edge), exact_text(-edge - pixel * static_cast<double>(rows)),
      exact_text(edge + pixel * static_cast<double>(cols)), exact_text(-edge)};
  const std::string size[]{std::to_string(cols), std::to_string(rows)};
  const char* arguments[]{"-of",
                          "MEM",
                          "-r",
                          kernel.c_str(),
                          "-ot",
                          "Float64",
                          "-et",
                          "0",
                          "-dstnodata",
                          "nan",
                          "-te",
                          extent[0].c_str(),
                          extent[1].c_str(),
                          extent[2].c_str(),
                          extent[3].c_str(),
                          "-ts",
                          size[0].c_str(),
                          size[1].c_str(),
                          nullptr};
  const std::unique_ptr<GDALWarpAppOptions, decltype(&GDALWarpAppOptionsFree)> options(
      GDALWarpAppOptionsNew(const_cast<char**>(arguments), nullptr), &GDALWarpAppOptionsFree);
  GDALDatasetH in = source.get();
  const Dataset out(source && options ? GDALDataset::FromHandle(
                                            GDALWarp("", nullptr, 1, &in, options.get(), nullptr))
                                      : nullptr);
  Grid<double> result({rows, cols});
  if (!out || out->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, static_cast<int>(cols),
                                              static_cast<int>(rows), result.samples().data(),
                                              static_cast<int>(cols), static_cast<int>(rows),
                                              GDT_Float64, 0, 0, nullptr) != CE_None)
    throw RasterError("gdalwarp -r " + kernel + " failed (GDAL: " + errors.message() + ")");
  return result;
}

}  // namespace arete::gdal

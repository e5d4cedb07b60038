// SPDX-License-Identifier: MIT
// gdalwarp's kernels on node-aligned extents are two members of the catalogue, exactly.
#include <gdal_priv.h>
#include <gdal_utils.h>
#include <gtest/gtest.h>

#include <cfloat>
#include <cmath>
#include <memory>

#include "arete/analysis/limit_stencil.h"
#include "arete/gdal/band_source.h"
#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "support/fields.h"
#include "support/source_dir.h"

namespace arete {
namespace {

using Dataset = std::unique_ptr<GDALDataset, decltype(&GDALClose)>;

// The grid as a raster of 1 x 1 pixels in memory.
Dataset in_memory(Grid<double>& grid) {
  gdal::register_formats();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
  Dataset dataset(driver->Create("", static_cast<int>(grid.cols()), static_cast<int>(grid.rows()),
                                 1, GDT_Float64, nullptr),
                  &GDALClose);
  double affine[6]{0, 1, 0, 0, 0, -1};
  dataset->SetGeoTransform(affine);
  EXPECT_EQ(dataset->GetRasterBand(1)->RasterIO(
                GF_Write, 0, 0, static_cast<int>(grid.cols()), static_cast<int>(grid.rows()),
                grid.samples().data(), static_cast<int>(grid.cols()), static_cast<int>(grid.rows()),
                GDT_Float64, 0, 0, nullptr),
            CE_None);
  return dataset;
}

// gdalwarp to the lattice on which sample (0, 0) stays where it is and `factor` samples stand
// where one stood.
Grid<double> warped(Grid<double> grid, const char* kernel, int factor) {
  const Dataset source = in_memory(grid);
  const Index cols = factor * (grid.cols() - 1) + 1;
  const Index rows = factor * (grid.rows() - 1) + 1;
  const double pixel = 1.0 / factor;
  const double edge = 0.5 - pixel / 2;
  const std::string extent[]{
      std::to_string(edge), std::to_string(-edge - pixel * static_cast<double>(rows)),
      std::to_string(edge + pixel * static_cast<double>(cols)), std::to_string(-edge)};
  const std::string width = std::to_string(cols);
  const std::string height = std::to_string(rows);
  const char* arguments[]{"-of",
                          "MEM",
                          "-r",
                          kernel,
                          "-ot",
                          "Float64",
                          "-et",
                          "0",
                          "-te",
                          extent[0].c_str(),
                          extent[1].c_str(),
                          extent[2].c_str(),
                          extent[3].c_str(),
                          "-ts",
                          width.c_str(),
                          height.c_str(),
                          nullptr};
  GDALWarpAppOptions* options = GDALWarpAppOptionsNew(const_cast<char**>(arguments), nullptr);
  GDALDatasetH in = source.get();
  const Dataset out(GDALDataset::FromHandle(GDALWarp("", nullptr, 1, &in, options, nullptr)),
                    &GDALClose);
  GDALWarpAppOptionsFree(options);
  Grid<double> result({rows, cols});
  EXPECT_EQ(
      out->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, static_cast<int>(cols), static_cast<int>(rows),
                                      result.samples().data(), static_cast<int>(cols),
                                      static_cast<int>(rows), GDT_Float64, 0, 0, nullptr),
      CE_None);
  return result;
}

// gdalwarp lowers its order near the border, where it has no rule; `rim` input samples are left
// out.
double largest_difference(const Grid<double>& a, const Grid<double>& b, Index rim, int factor) {
  EXPECT_EQ(a.extent(), b.extent());
  double largest = 0;
  for (Index r = rim * factor; r < a.rows() - rim * factor; ++r)
    for (Index c = rim * factor; c < a.cols() - rim * factor; ++c)
      largest = std::max(largest, std::abs(a(r, c) - b(r, c)));
  return largest;
}

TEST(gdalwarp, one_level_of_the_four_point_scheme_is_the_cubic_kernel) {
  // Exactly where no rounding happens (integers and eighths, dyadic weights)...
  const gdal::Raster dem(arete::test::source_dir() + "/data/jacksboro_srtm3.tif");
  for (const Grid<double>& input :
       {gdal::read_band<double>(dem, dem.bands().front()), test::dyadic_heights({21, 50}, 2)})
    EXPECT_EQ(largest_difference(refine(input, parse_scheme("four-point")),
                                 warped(input, "cubic", 2), 2, 2),
              0);
  // ... and to some ulps of the heights, up to 900, where sums are taken in another order.
  const Grid<double> input = test::random_heights({40, 33}, 1);
  EXPECT_LE(largest_difference(refine(input, parse_scheme("four-point")), warped(input, "cubic", 2),
                               2, 2),
            4 * 512 * DBL_EPSILON);
}

TEST(gdalwarp, the_limit_of_the_cubic_b_spline_is_the_cubicspline_kernel) {
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Stencil limit = *limit_stencil(scheme.mask());
  for (const int levels : {3, 4}) {
    RefineOptions options;
    options.levels = levels;
    options.final_x = limit;
    options.final_y = limit;
    const Grid<double> input = test::random_heights({30, 24}, 5);
    const Grid<double> fine = refine(input, scheme, options);
    const int factor = 1 << levels;
    const Grid<double> kernel = warped(input, "cubicspline", factor);
    EXPECT_LE(largest_difference(fine, kernel, 2, factor), 1e-10);
    // Without the limit stencil level 3 is not there yet: the oracle can tell.
    options.final_x.reset();
    options.final_y.reset();
    EXPECT_GT(largest_difference(refine(input, scheme, options), kernel, 2, factor), 1e-3);
  }
}

}  // namespace
}  // namespace arete

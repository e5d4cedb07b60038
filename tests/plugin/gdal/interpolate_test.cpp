// SPDX-License-Identifier: MIT
// Rasters refined so that the limit passes through their samples, block of rows by block of rows.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/analysis/limit_stencil.h"
#include "arete/fractal/arc_matrices.h"
#include "arete/gdal/band_source.h"
#include "arete/gdal/refine_raster.h"
#include "arete/variational/cardinal.h"
#include "make_raster.h"
#include "support/fields.h"
#include "support/schemes.h"
#include "support/source_dir.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using gdal::Raster;
using gdal::SampleType;

Stencil at_sample(const Scheme& scheme) {
  const Mask& mask = scheme.mask();
  return limit_stencil_at(mask, mask.tau() / (mask.arity() - 1)).value();
}

gdal::RasterOutput through_samples(const Scheme& scheme) {
  return {SampleType::float64, {}, 1e9, gdal::LimitWeights{at_sample(scheme), at_sample(scheme)}};
}

Grid<double> samples_of(const std::string& path) {
  const Raster raster(path);
  return gdal::read_band<double>(raster, raster.bands().front());
}

TEST(interpolate_raster, the_limit_surface_passes_through_the_dem) {
  const test::TemporaryFolder folder;
  const std::string dem = arete::test::source_dir() + "/data/jacksboro_srtm3.tif";
  const Grid<double> heights = samples_of(dem);
  for (const char* name : {"b-spline:degree=3", "b-spline:degree=5"}) {
    const Scheme scheme = parse_scheme(name);
    RefineOptions options;
    options.levels = 1;
    options.final_x = options.final_y = limit_stencil(scheme.mask());
    gdal::refine_raster(Raster(dem), folder.file("out.tif"), scheme, scheme, options,
                        through_samples(scheme), {});
    const Grid<double> fine = samples_of(folder.file("out.tif"));
    double largest = 0;
    for (Index r = 0; r < heights.rows(); ++r)
      for (Index c = 0; c < heights.cols(); ++c)
        largest = std::max(largest, std::abs(fine(2 * r, 2 * c) - heights(r, c)));
    EXPECT_LE(largest, 1e-9) << name;
  }
}

TEST(interpolate_raster, blocks_of_a_tall_raster_equal_the_whole_in_memory) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.extent = {700, 9};
  spec.bands = 2;
  const auto height = [](int band, Index r, Index c) {
    return std::sin(static_cast<double>(band * r * r + 7 * c)) * 300;
  };
  test::make_raster(folder.file("tall.tif"), spec, height);
  const Scheme scheme = parse_scheme("chaikin");
  RefineOptions options;
  options.levels = 2;
  gdal::refine_raster(Raster(folder.file("tall.tif")), folder.file("out.tif"), scheme, scheme,
                      options, through_samples(scheme), {});
  const Grid<double> heights = samples_of(folder.file("tall.tif"));
  const Grid<double> control =
      cardinal_control(heights.view(), at_sample(scheme), at_sample(scheme), options.boundaries);
  const Grid<double> expected = refine(control, scheme, options);
  const Grid<double> actual = samples_of(folder.file("out.tif"));
  ASSERT_EQ(actual.extent(), expected.extent());
  for (std::size_t i = 0; i < expected.samples().size(); ++i)
    ASSERT_NEAR(actual.samples()[i], expected.samples()[i], 1e-9);
}

TEST(interpolate_raster, a_missing_sample_is_refused_by_its_place) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.nodata = -1;
  test::make_raster(folder.file("hole.tif"), spec,
                    [](int, Index r, Index c) { return r == 3 && c == 4 ? -1.0 : 5.0; });
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  try {
    gdal::refine_raster(Raster(folder.file("hole.tif")), folder.file("out.tif"), scheme, scheme, {},
                        through_samples(scheme), {});
    ADD_FAILURE() << "accepted";
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find("row 3, column 4"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace arete

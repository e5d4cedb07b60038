// SPDX-License-Identifier: MIT
// arete compare: what it measures, on which lattices, and what it refuses.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/gdal/geotiff.h"
#include "expect_error.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::dem;
using test::expect_error;
using test::run_json;

void write(const std::string& path, const Grid<double>& heights, const Georeference& place,
           const std::string& crs = "") {
  gdal::GeoTiffSpec spec;
  spec.extent = heights.extent();
  spec.type = gdal::SampleType::float64;
  spec.georeference = place;
  spec.crs = crs;
  spec.bands.resize(1);
  spec.nodata = std::numeric_limits<double>::quiet_NaN();
  gdal::GeoTiffWriter writer(path, spec);
  writer.write<double>(1, 0, heights.view());
  writer.close();
}

const Georeference unit{{0, 1, 0, 0, 0, -1}};

TEST(cli_compare, a_raster_with_itself_differs_by_nothing) {
  const auto report = run_json({"compare", dem, dem, "--json"});
  for (const char* key : {"rmse", "bias", "mean_absolute", "max", "slope_rmse"})
    EXPECT_EQ(report.at(key), 0) << key;
  EXPECT_EQ(report.at("compared"), 403 * 344);
  EXPECT_LT(report.at("spectral_slope").at("first"), -1);
}

TEST(cli_compare, the_one_sample_that_differs_is_found_with_its_place) {
  const test::TemporaryFolder folder;
  Grid<double> z({40, 50}, 7.0);
  write(folder.file("a.tif"), z, unit);
  z(12, 30) = 10;
  z(0, 0) = std::numeric_limits<double>::quiet_NaN();
  write(folder.file("b.tif"), z, unit);
  const auto report = run_json({"compare", folder.file("a.tif"), folder.file("b.tif"), "--json"});
  EXPECT_NEAR(report.at("rmse").get<double>(), std::sqrt(9.0 / 1999), 1e-12);
  EXPECT_NEAR(report.at("bias").get<double>(), 3.0 / 1999, 1e-12);
  EXPECT_EQ(report.at("only_first"), 1);
  EXPECT_EQ(report.at("max_at").at("row"), 12);
  EXPECT_EQ(report.at("max_at").at("x"), 30.5);
  EXPECT_EQ(report.at("max_at").at("y"), -12.5);
  const auto text = test::run_arete({"compare", folder.file("a.tif"), folder.file("b.tif")});
  EXPECT_NE(text.out.find("row 12, column 30"), std::string::npos) << text.out;
}

TEST(cli_compare, a_refinement_is_compared_at_the_samples_of_its_control_grid) {
  const test::TemporaryFolder folder;
  const std::string fine = folder.file("fine.tif");
  ASSERT_EQ(
      test::run_arete({"refine", dem, fine, "--scheme", "four-point", "--levels", "2"}).exit_code,
      0);
  // Interpolatory: the samples are still there.
  for (const auto& order : {std::pair{dem, fine}, std::pair{fine, dem}}) {
    const auto report = run_json({"compare", order.first, order.second, "--json"});
    EXPECT_EQ(report.at("compared"), 403 * 344);
    EXPECT_EQ(report.at("max"), 0);
  }
  ASSERT_EQ(
      test::run_arete({"refine", dem, fine, "--scheme", "gentle", "--levels", "2", "--overwrite"})
          .exit_code,
      0);
  EXPECT_GT(run_json({"compare", dem, fine, "--json"}).at("rmse"), 1);
}

TEST(cli_compare, parts_are_compared_where_they_overlap) {
  const test::TemporaryFolder folder;
  Grid<double> whole({20, 30});
  for (Index r = 0; r < 20; ++r)
    for (Index c = 0; c < 30; ++c) whole(r, c) = static_cast<double>(100 * r + c);
  Grid<double> part({10, 12});
  for (Index r = 0; r < 10; ++r)
    for (Index c = 0; c < 12; ++c) part(r, c) = static_cast<double>(100 * (r + 15) + c + 4);
  write(folder.file("whole.tif"), whole, unit);
  write(folder.file("part.tif"), part, {{4, 1, 0, -15, 0, -1}});
  const auto report =
      run_json({"compare", folder.file("whole.tif"), folder.file("part.tif"), "--json"});
  EXPECT_EQ(report.at("compared"), 5 * 12);
  EXPECT_EQ(report.at("max"), 0);
}

TEST(cli_compare, what_cannot_be_compared_is_refused) {
  const test::TemporaryFolder folder;
  const Grid<double> z({10, 10}, 1.0);
  const auto with = [&](const char* name, const Georeference& place, const std::string& crs = "") {
    write(folder.file(name), z, place, crs);
    return folder.file(name);
  };
  const std::string a = with("a.tif", unit);
  expect_error({"compare", a, with("half.tif", {{0.5, 1, 0, 0, 0, -1}})}, 1, "between those");
  expect_error({"compare", a, with("spacing.tif", {{0, 1.5, 0, 0, 0, -1.5}})}, 1, "gdalwarp");
  expect_error({"compare", a, with("far.tif", {{1000, 1, 0, 0, 0, -1}})}, 1, "do not overlap");
  expect_error({"compare", a, folder.file("absent.tif")}, 1, "does not exist");
  expect_error({"compare", a, a, "--band", "3"}, 2, "no data band 3");
  expect_error({"compare", a, a, "--max-memory", "1K"}, 1, "memory");
  Grid<double> none({10, 10}, std::numeric_limits<double>::quiet_NaN());
  write(folder.file("none.tif"), none, unit);
  expect_error({"compare", a, folder.file("none.tif")}, 1, "no valid sample in common");
  const gdal::Raster geographic(dem);
  expect_error({"compare", dem,
                with("utm.tif", geographic.place(), R"(LOCAL_CS["somewhere",UNIT["metre",1]])")},
               1, "different reference systems");
}

}  // namespace
}  // namespace arete

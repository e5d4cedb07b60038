// SPDX-License-Identifier: MIT
// arete grid: text and layers of points, their place on earth, and bad input of every kind.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "arete/gdal/band_source.h"
#include "expect_error.h"
#include "run_program.h"
#include "support/source_dir.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::Arguments;
using test::run_json;

const std::string davis = arete::test::source_dir() + "/data/davis_topo.csv";

struct GridRun {
  test::TemporaryFolder folder;
  std::string out = folder.file("out.tif");

  std::string text(const std::string& name, const std::string& contents) const {
    std::ofstream(folder.file(name)) << contents;
    return folder.file(name);
  }
  Grid<double> heights() const {
    const gdal::Raster raster(out);
    return gdal::read_band<double>(raster, raster.bands().front());
  }
};

TEST(cli_grid, the_survey_becomes_a_control_grid) {
  const GridRun run;
  const auto report =
      run_json({"grid", davis, run.out, "--spacing", "0.2", "--crs", "EPSG:32616", "--json"});
  EXPECT_EQ(report.at("points").at("used"), 52);
  EXPECT_EQ(report.at("rows"), 32);
  EXPECT_EQ(report.at("cols"), 31);
  EXPECT_GT(report.at("missing"), 0);
  EXPECT_LT(report.at("distance_to_points").at("rmse"), 5);
  const gdal::Raster raster(run.out);
  EXPECT_EQ(raster.georeference()->registration, Registration::point);
  EXPECT_NE(raster.crs().find("16N"), std::string::npos);
  // Within the range of the survey, but for the overshoot of a smooth surface.
  const Grid<double> heights = run.heights();
  for (const double z : heights.samples())
    if (!std::isnan(z)) {
      EXPECT_GT(z, 690 - 30);
      EXPECT_LT(z, 960 + 30);
    }
}

TEST(cli_grid, every_way_to_write_the_same_points_gives_the_same_grid) {
  const GridRun run;
  const char* const ways[] = {
      "0,0,1\n4,0,5\n0,3,4\n4,3,8\n",
      "x,y,z\n0,0,1\n4,0,5\n0,3,4\n4,3,8\n",
      "# a comment\nEasting;Northing;Elevation\n0;0;1\n// another\n4,0;0,0;5,0\n\n0;3;4\n4;3;8\n",
      "0 0 1\n4   0 5\n  0 3 4\n% and this\n4 3 8\n",
      "\xEF\xBB\xBFz\tx\ty\r\n1\t0\t0\r\n5\t4\t0\r\n4\t0\t3\r\n8\t4\t3\r\n",
      "id|x|y|z|who\n1|0|0|1|\"a|b\"\n2|4|0|5|\n3|0|3|4|c\n4|4|3|8|d\n"};
  for (const char* way : ways) {
    const std::string in = run.text("in.xyz", way);
    const auto report = run_json({"grid", in, run.out, "--spacing", "1", "--overwrite", "--json"});
    EXPECT_EQ(report.at("points").at("used"), 4) << way;
    const Grid<double> z = run.heights();
    ASSERT_EQ(z.extent(), (Extent{4, 5})) << way;
    for (Index r = 0; r < 4; ++r)
      for (Index c = 0; c < 5; ++c)
        EXPECT_NEAR(z(r, c), 1 + static_cast<double>(c) + static_cast<double>(3 - r), 1e-6) << way;
  }
}

TEST(cli_grid, columns_are_chosen_by_name_or_number) {
  const GridRun run;
  const std::string in =
      run.text("in.csv", "id,depth,east2,z\n7,1,0,0\n8,5,4,0\n9,4,0,3\n10,8,4,3\n");
  for (const char* columns : {"east2,z,depth", "3,4,2"}) {
    (void)run_json(
        {"grid", in, run.out, "--spacing", "1", "--columns", columns, "--overwrite", "--json"});
    EXPECT_NEAR(run.heights()(0, 0), 4, 1e-6) << columns;
    EXPECT_NEAR(run.heights()(3, 4), 5, 1e-6) << columns;
  }
}

TEST(cli_grid, point_layers_come_through_gdal_with_their_reference_system) {
  const GridRun run;
  std::string features;
  const double places[4][3] = {
      {500000, 4000000, 1}, {500400, 4000000, 5}, {500000, 4000300, 4}, {500400, 4000300, 8}};
  for (const auto& p : places)
    features += std::string(features.empty() ? "" : ",") +
                R"({"type":"Feature","properties":{"h":)" + std::to_string(p[2]) +
                R"(},"geometry":{"type":"Point","coordinates":[)" + std::to_string(p[0]) + "," +
                std::to_string(p[1]) + "]}}";
  const std::string in = run.text(
      "in.geojson", R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":)"
                    R"("urn:ogc:def:crs:EPSG::32616"}},"features":[)" +
                        features + "]}");
  (void)run_json({"grid", in, run.out, "--spacing", "100", "--z-field", "h", "--json"});
  EXPECT_NEAR(run.heights()(1, 2), 5, 1e-5);
  const gdal::Raster raster(run.out);
  EXPECT_NE(raster.crs().find("16N"), std::string::npos);
  EXPECT_EQ(raster.georeference()->position(3, 0).x, 500000);
  EXPECT_EQ(raster.georeference()->position(3, 0).y, 4000000);
  const std::string out = run.folder.file("other.tif");
  test::expect_error({"grid", in, out, "--spacing", "100"}, 1, "has no z");
  test::expect_error({"grid", in, out, "--spacing", "100", "--z-field", "k"}, 1, "no field 'k'");
  test::expect_error({"grid", in, out, "--spacing", "100", "--layer", "k"}, 1, "no layer 'k'");
  test::expect_error({"grid", in, out, "--spacing", "100", "--z-field", "h", "--crs", "EPSG:4326"},
                     1, "another reference system");
}

TEST(cli_grid, bad_files_are_refused_with_their_place) {
  const GridRun run;
  const auto with = [&](const std::string& text, Arguments more = {}) {
    Arguments all{"grid", run.text("in.csv", text), run.out, "--spacing", "1"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const std::string square = "0,0,1\n4,0,5\n0,3,4\n4,3,8\n";
  using test::expect_error;
  expect_error(with(""), 1, "holds no points");
  expect_error(with("x,y,z\n"), 1, "holds no points");
  expect_error(with("0,0,1\n"), 2, "one place");
  expect_error(with("0,0,1\n1,1,1\n"), 2, "one line");
  expect_error(with("0,0,1\n0,0,1\n0,0,1\n"), 2, "one place");
  expect_error(with("0,0,1\n1,0,zwei\n"), 1, "line 2, column 3 (z): 'zwei'");
  expect_error(with("0,0,1\n1,,2\n"), 1, "line 2, column 2 (y): ''");
  expect_error(with("0,0,1\n1,0\n"), 1, "line 2 has 2 columns");
  expect_error(with("x,y,value\n0,0,1\n"), 1, "--columns");
  expect_error(with("a,b\n1,2\n"), 1, "column 3 is needed");
  expect_error(with(square, {"--columns", "x,y,z"}), 1, "no column 'x'");
  expect_error(with(square, {"--columns", "1,2"}), 2, "three names or numbers");
  expect_error(with(square, {"--columns", "1,2,9"}), 1, "column 9");
  expect_error(with(square, {"--separator", "ab"}), 2, "one character");
  expect_error(with(square, {"--crs", "EPSG:99999999"}), 1, "no reference system");
  expect_error(
      with("500000,4000000,1\n500004,4000000,1\n500000,4000003,1\n", {"--crs", "EPSG:4326"}), 1,
      "no longitude and latitude");
  expect_error(with(square, {"--size", "3x3"}), 2, "either --spacing D or --size");
  expect_error(with(square, {"--box", "1,2,3"}), 2, "XMIN,YMIN,XMAX,YMAX");
  expect_error(with(square, {"--method", "kriging"}), 2, "natural-neighbour, linear or idw");
  expect_error(with(square, {"--outside", "wrap"}), 2, "nodata, nearest or extrapolate");
  expect_error(with(square, {"--layer", "x"}), 2, "vector layers");
  expect_error(with("0,0,1\n1e9,1e9,1\n0,1e9,1\n"), 2, "2^31");
  expect_error(with("0,0,1\n30000,30000,1\n0,30000,1\n", {"--max-memory", "1G"}), 1, "memory");
  expect_error({"grid", run.folder.file("absent.csv"), run.out, "--spacing", "1"}, 1,
               "cannot be read");
  expect_error({"grid", run.folder.file("absent.gpkg"), run.out, "--spacing", "1"}, 1,
               "does not exist");
  expect_error({"grid", run.text("in.md", "text"), run.out, "--spacing", "1"}, 1,
               "vector layer that 'ogrinfo' opens");
  expect_error({"grid", davis, run.folder.file("out.vts"), "--spacing", "1"}, 2, "name it .tif");
  expect_error({"grid", davis, run.out}, 2, "either --spacing D or --size");
  EXPECT_EQ(run.folder.entries(), 2);
  (void)run_json({"grid", davis, run.out, "--size", "9x9", "--json"});
  expect_error({"grid", davis, run.out, "--size", "9x9"}, 1, "give --overwrite");
}

TEST(cli_grid, points_without_height_are_passed_over_and_reported) {
  const GridRun run;
  const std::string in = run.text("in.csv", "0,0,1\n4,0,5\n0,3,4\n4,3,8\n2,2,nan\n4,3,8\n4,3,8\n");
  const auto report = run_json({"grid", in, run.out, "--spacing", "1", "--json"});
  EXPECT_EQ(report.at("points").at("given"), 7);
  EXPECT_EQ(report.at("points").at("not_finite"), 1);
  EXPECT_EQ(report.at("points").at("merged"), 2);
}

}  // namespace
}  // namespace arete

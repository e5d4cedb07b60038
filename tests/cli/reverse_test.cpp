// SPDX-License-Identifier: MIT
// arete coarsen, restore and contour on the real program.
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <random>

#include "arete/gdal/band_source.h"
#include "arete/gdal/geotiff.h"
#include "run_program.h"
#include "support/fields.h"
#include "support/source_dir.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::Arguments;
using test::dem;
using test::run_arete;
using test::run_json;

const std::string contour = arete::test::source_dir() + "/data/poland_contour.csv";

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

Grid<double> samples_of(const std::string& path, std::size_t band = 0) {
  const gdal::Raster raster(path);
  return gdal::read_band<double>(raster, raster.bands().at(band));
}

bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

void expect_same_samples(const Grid<double>& actual, const Grid<double>& expected,
                         const std::string& what) {
  ASSERT_EQ(actual.extent(), expected.extent()) << what;
  Index different = 0;
  for (std::size_t i = 0; i < expected.samples().size(); ++i)
    different += same(actual.samples()[i], expected.samples()[i]) ? 0 : 1;
  EXPECT_EQ(different, 0) << what;
}

struct Files {
  explicit Files(const test::TemporaryFolder& folder)
      : coarse(folder.file("coarse.tif")),
        details(folder.file("details.ard")),
        back(folder.file("back.tif")) {}
  std::string coarse, details, back;
};

nlohmann::json coarsen(const std::string& in, const Files& files, Arguments more) {
  Arguments all{"coarsen", in, files.coarse, "--details", files.details, "--json", "--overwrite"};
  all.insert(all.end(), more.begin(), more.end());
  return run_json(all);
}

nlohmann::json restore(const Files& files, Arguments more = {}) {
  Arguments all{"restore",     files.coarse, files.back,   "--details",
                files.details, "--json",     "--overwrite"};
  all.insert(all.end(), more.begin(), more.end());
  return run_json(all);
}

TEST(cli_reverse, the_bundled_dem_comes_back_sample_for_sample_at_its_place) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  const Grid<double> heights = samples_of(dem);
  for (const Arguments& scheme :
       {Arguments{"--scheme", "chaikin", "--mode", "local", "--levels", "3"},
        Arguments{"--scheme", "gentle", "--levels", "2"},
        Arguments{"--scheme", "ternary-two-step", "--levels", "2", "--boundary", "clamp"},
        Arguments{"--scheme", "four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7"},
        Arguments{"--scheme", "b-spline:degree=3", "--levels", "5", "--threads", "0"}}) {
    const auto report = coarsen(dem, files, scheme);
    EXPECT_LE(report.at("max_error"), 1e-8) << scheme[1];
    EXPECT_EQ(restore(files).at("type"), "float32");
    expect_same_samples(samples_of(files.back), heights, scheme[1]);
    const gdal::Raster before(dem);
    const gdal::Raster after(files.back);
    EXPECT_EQ(after.georeference()->affine, before.georeference()->affine) << scheme[1];
    EXPECT_EQ(after.crs(), before.crs());
    const Index numbers =
        report.at("coarse_rows").get<Index>() * report.at("coarse_cols").get<Index>() +
        report.at("details_all").get<Index>();
    EXPECT_EQ(numbers, heights.rows() * heights.cols()) << scheme[1];
  }
  EXPECT_EQ(folder.entries(), 3);
}

TEST(cli_reverse, refining_then_coarsening_gives_the_raster_back_in_its_place) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  for (const char* scheme : {"chaikin", "four-point", "gentle", "three-point"}) {
    ASSERT_EQ(run_arete({"refine", dem, folder.file("fine.tif"), "--scheme", scheme, "--type",
                         "float64", "--overwrite"})
                  .exit_code,
              0);
    const auto report = coarsen(folder.file("fine.tif"), files, {"--scheme", scheme});
    const Grid<double> coarse = samples_of(files.coarse);
    const Grid<double> heights = samples_of(dem);
    ASSERT_EQ(coarse.extent(), heights.extent()) << scheme;
    for (std::size_t i = 0; i < heights.samples().size(); ++i)
      ASSERT_NEAR(coarse.samples()[i], heights.samples()[i], 1e-8) << scheme;
    const gdal::Raster before(dem);
    const gdal::Raster after(files.coarse);
    for (std::size_t i = 0; i < 6; ++i)
      EXPECT_NEAR(after.georeference()->affine[i], before.georeference()->affine[i], 1e-12)
          << scheme;
    // Details of smooth data are rounding errors; a threshold of a micrometre drops them all.
    EXPECT_EQ(coarsen(folder.file("fine.tif"), files, {"--scheme", scheme, "--threshold", "1e-6"})
                  .at("details_kept"),
              0);
    EXPECT_GT(report.at("details_all"), 0);
  }
}

// Two bands of heights with holes at the rim, in the middle and alone.
std::string raster_with_holes(const test::TemporaryFolder& folder, double nodata) {
  const std::string path = folder.file("holes.tif");
  gdal::GeoTiffSpec spec;
  spec.extent = {37, 50};
  spec.georeference = Georeference{{1000, 10, 2, 5000, 3, -10}, Registration::point};
  gdal::BandInfo band;
  spec.bands = {band, band};
  spec.nodata = nodata;
  gdal::GeoTiffWriter writer(path, spec);
  for (int number = 1; number <= 2; ++number) {
    Grid<float> heights = test::random_heights<float>(spec.extent, static_cast<unsigned>(number));
    for (Index r = 10; r < 22; ++r)
      for (Index c = 0; c < 15; ++c) heights(r, c) = static_cast<float>(nodata);
    heights(36, 49) = heights(5, 5) = heights(0, 20) = static_cast<float>(nodata);
    if (number == 2) heights(30, 30) = static_cast<float>(nodata);
    writer.write<float>(number, 0, std::as_const(heights).view());
  }
  writer.close();
  return path;
}

TEST(cli_reverse, holes_come_back_as_they_were) {
  for (const double nodata : {-9999.0, std::numeric_limits<double>::quiet_NaN()}) {
    const test::TemporaryFolder folder;
    const Files files(folder);
    const std::string in = raster_with_holes(folder, nodata);
    for (const Arguments& scheme : {Arguments{"--scheme", "chaikin", "--mode", "local"},
                                    Arguments{"--scheme", "b-spline:degree=3", "--levels", "3"},
                                    Arguments{"--scheme", "gentle", "--levels", "2"}}) {
      (void)coarsen(in, files, scheme);
      (void)restore(files);
      for (const std::size_t band : {0, 1}) {
        const Grid<double> before = samples_of(in, band);
        const Grid<double> after = samples_of(files.back, band);
        ASSERT_EQ(after.extent(), before.extent());
        for (std::size_t i = 0; i < before.samples().size(); ++i) {
          ASSERT_EQ(std::isnan(after.samples()[i]), std::isnan(before.samples()[i])) << scheme[1];
          if (!std::isnan(before.samples()[i])) {
            ASSERT_NEAR(after.samples()[i], before.samples()[i], 1e-4) << scheme[1];
          }
        }
      }
      const gdal::Raster after(files.back);
      ASSERT_TRUE(after.bands()[0].nodata);
      EXPECT_TRUE(same(*after.bands()[0].nodata, nodata));
      EXPECT_EQ(after.georeference()->registration, Registration::point);
      // The hole in the middle is one of the coarse raster too.
      const Grid<double> coarse = samples_of(files.coarse);
      EXPECT_TRUE(std::isnan(coarse(coarse.rows() * 16 / 37, coarse.cols() / 10))) << scheme[1];
    }
  }
}

TEST(cli_reverse, any_number_of_levels_is_restored_and_equals_a_shorter_coarsening) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  (void)coarsen(dem, files, {"--scheme", "b-spline:degree=3", "--levels", "3"});
  for (int levels = 0; levels <= 3; ++levels) {
    const auto report = restore(files, {"--levels", std::to_string(levels), "--type", "float64"});
    EXPECT_EQ(report.at("levels"), levels);
    const std::string direct = folder.file("direct.tif");
    ASSERT_EQ(run_arete({"coarsen", dem, direct, "--scheme", "b-spline:degree=3", "--levels",
                         std::to_string(3 - levels), "--overwrite"})
                  .exit_code,
              0);
    const Grid<double> a = samples_of(files.back);
    const Grid<double> b = samples_of(direct);
    ASSERT_EQ(a.extent(), b.extent());
    for (std::size_t i = 0; i < a.samples().size(); ++i)
      ASSERT_NEAR(a.samples()[i], b.samples()[i], 1e-7);
    const auto x = gdal::Raster(files.back).georeference()->affine;
    const auto y = gdal::Raster(direct).georeference()->affine;
    for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(x[i], y[i], 1e-12);
  }
}

TEST(cli_reverse, thinned_details_lose_what_the_report_says) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  const auto rmse_of = [&] {
    const Grid<double> before = samples_of(dem);
    const Grid<double> after = samples_of(files.back);
    double sum = 0;
    for (std::size_t i = 0; i < before.samples().size(); ++i)
      sum += std::pow(before.samples()[i] - after.samples()[i], 2);
    return std::sqrt(sum / static_cast<double>(before.samples().size()));
  };
  const Arguments scheme{"--scheme", "b-spline:degree=3", "--levels", "3"};
  const auto all = coarsen(dem, files, scheme);
  for (const auto& [option, value] :
       {std::pair{"--threshold", "5"}, {"--threshold", "20"}, {"--target-rmse", "3"}}) {
    Arguments more = scheme;
    more.insert(more.end(), {option, value});
    const auto report = coarsen(dem, files, more);
    EXPECT_TRUE(restore(files).at("lossy"));
    EXPECT_NEAR(rmse_of(), report.at("rmse"), 1e-4) << option;
    EXPECT_LT(report.at("details_kept"), all.at("details_all").get<Index>() / 2) << option;
    EXPECT_LT(report.at("details_bytes"), all.at("details_bytes").get<Index>() / 2) << option;
    if (std::string(option) == "--target-rmse") {
      EXPECT_LE(report.at("rmse"), 3.0);
      EXPECT_GT(report.at("rmse"), 2.9);
    }
  }
}

void expect_refused(const Arguments& arguments, int code, const std::string& part) {
  const test::Run run = run_arete(arguments);
  EXPECT_EQ(run.exit_code, code) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run.err.rfind("arete: ", 0), 0u) << run.err;
  EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  EXPECT_NE(run.err.find(part), std::string::npos) << run.err;
}

TEST(cli_reverse, bad_details_are_refused_and_nothing_is_written) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  (void)coarsen(dem, files, {"--scheme", "chaikin", "--levels", "2"});
  const std::string good = bytes_of(files.details);
  const std::string bad = folder.file("bad.ard");
  const auto refused = [&](const std::string& bytes, const std::string& part) {
    std::ofstream(bad, std::ios::binary) << bytes;
    expect_refused({"restore", files.coarse, files.back, "--details", bad}, 1, part);
  };
  refused("", "not a details file");
  refused(bytes_of(contour), "not a details file");
  refused(bytes_of(dem), "not a details file");
  refused(good.substr(0, good.size() / 2), "cut off");
  refused(good.substr(0, 30), "cut off");
  refused(good + "x", "follows the end");
  std::string newer = good;
  newer[8] = 9;
  refused(newer, "newer arete (details version 9");
  std::mt19937 random(3);
  for (int round = 0; round < 25; ++round) {
    std::string changed = good;
    const std::size_t place = 24 + random() % (good.size() - 24);
    changed[place] = static_cast<char>(changed[place] ^ (1 << (random() % 8)));
    refused(changed, "damaged");
  }
  expect_refused({"restore", files.coarse, files.back, "--details", folder.file("absent")}, 1,
                 "cannot be read");
  expect_refused({"restore", files.coarse, files.back, "--details", folder.path().string()}, 1,
                 "is a folder");
  EXPECT_EQ(folder.entries(), 3);  // coarse, details, bad
}

TEST(cli_reverse, a_wrong_or_edited_coarse_raster_is_noticed) {
  const test::TemporaryFolder folder;
  const Files files(folder);
  (void)coarsen(dem, files, {"--scheme", "b-spline:degree=3", "--levels", "2"});
  expect_refused({"restore", dem, files.back, "--details", files.details}, 1,
                 "give the coarse raster it was written with");
  const std::string other = folder.file("other.tif");
  ASSERT_EQ(run_arete({"coarsen", dem, other, "--scheme", "four-point", "--levels", "2"}).exit_code,
            0);
  expect_refused({"restore", other, files.back, "--details", files.details}, 1, "checksum");
  // Multiresolution editing: raise the coarse raster by 100 m, and the terrain rises by 100 m.
  const gdal::Raster coarse(files.coarse);
  Grid<double> raised = samples_of(files.coarse);
  for (double& value : raised.samples()) value += 100;
  {
    gdal::GeoTiffSpec spec;
    spec.extent = raised.extent();
    spec.type = gdal::SampleType::float64;
    spec.bands = coarse.bands();
    spec.georeference = coarse.georeference();
    gdal::GeoTiffWriter writer(folder.file("raised.tif"), spec);
    writer.write<double>(1, 0, std::as_const(raised).view());
    writer.close();
  }
  ASSERT_EQ(run_arete({"restore", folder.file("raised.tif"), files.back, "--details", files.details,
                       "--edited"})
                .exit_code,
            0);
  const Grid<double> before = samples_of(dem);
  const Grid<double> after = samples_of(files.back);
  for (std::size_t i = 0; i < before.samples().size(); ++i)
    ASSERT_NEAR(after.samples()[i], before.samples()[i] + 100, 1e-3);
}

TEST(cli_reverse, misuse_exits_with_2_and_writes_nothing) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.tif");
  const std::string ard = folder.file("out.ard");
  expect_refused({"coarsen", dem, out}, 2, "--scheme is required");
  expect_refused({"coarsen", dem, folder.file("out.vts"), "--scheme", "chaikin"}, 2, ".tif");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--mode", "local"}, 2,
                 "use the mode least-squares");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--mode", "best"}, 2,
                 "no reverse mode 'best'");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--boundary", "none"}, 2,
                 "boundary none");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--levels", "-1"}, 2, "negative");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--threshold", "1"}, 2,
                 "give --details");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--details", ard, "--threshold", "1",
                  "--target-rmse", "1"},
                 2, "exclude each other");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--details", ard, "--threshold", "-1"},
                 2, "impossible");
  expect_refused({"coarsen", dem, out, "--scheme", "gentle", "--details", out}, 2,
                 "names the coarse output");
  expect_refused({"coarsen", dem, out, "--scheme", "corner-cutting:u=1/2,v=1/2"}, 2,
                 "cannot be reversed");
  expect_refused({"coarsen", dem, out, "--scheme", "chaikin", "--max-memory", "1M"}, 1, "memory");
  expect_refused({"contour", contour, out}, 2, ".csv");
  expect_refused({"contour", contour, folder.file("o.csv"), "--levels", "12", "--pictures",
                  folder.file("p.png")},
                 1, "make no picture");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(cli_reverse, the_contour_of_poland_halves_and_comes_back) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("coarse.csv");
  const auto report = run_json({"contour", contour, out, "--scheme", "chaikin", "--levels", "5",
                                "--pictures", folder.file("level.png"), "--json"});
  EXPECT_EQ(report.at("sizes"), (std::vector<int>{1309, 655, 328, 164, 82, 41}));
  EXPECT_LE(report.at("max_error"), 1e-12);
  EXPECT_EQ(report.at("mode"), "local");
  std::ifstream stream(out);
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "lon,lat");
  int points = 0;
  while (std::getline(stream, line)) {
    double lon = 0;
    double lat = 0;
    char comma = 0;
    std::istringstream(line) >> lon >> comma >> lat;
    EXPECT_TRUE(lon > 13.5 && lon < 24.8 && lat > 48.5 && lat < 55.4) << line;
    ++points;
  }
  EXPECT_EQ(points, 41);
  for (int level = 0; level <= 5; ++level)
    EXPECT_GT(std::filesystem::file_size(folder.file("level-" + std::to_string(level) + ".png")),
              5000u);
  EXPECT_EQ(folder.entries(), 7);
  const auto best = run_json(
      {"contour", contour, out, "--scheme", "gentle", "--levels", "2", "--overwrite", "--json"});
  EXPECT_EQ(best.at("mode"), "least-squares");
}

}  // namespace
}  // namespace arete

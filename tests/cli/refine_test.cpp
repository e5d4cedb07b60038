// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <signal.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <set>

#include "arete/gdal/band_source.h"
#include "arete/refine/refiner.h"
#include "plugin/gdal/make_raster.h"
#include "run_program.h"
#include "support/schemes.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::dem;
using test::run_arete;
using test::run_json;

std::string bytes_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(cli_refine, reports_the_keys_of_the_contract) {
  const test::TemporaryFolder folder;
  const auto report = run_json({"refine", dem, folder.file("out.tif"), "--scheme", "gentle",
                                "--levels", "2", "--threads", "1", "--json"});
  for (const char* key : {"input", "output", "rows", "cols", "levels", "scheme", "seconds",
                          "samples_per_second", "threads"})
    EXPECT_TRUE(report.contains(key)) << key;
  EXPECT_EQ(report.at("rows"), 4 * 343 + 1);
  EXPECT_EQ(report.at("cols"), 4 * 402 + 1);
  EXPECT_EQ(report.at("threads"), 1);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_refine, the_bundled_dem_goes_through_every_scheme_of_the_catalogue) {
  const test::TemporaryFolder folder;
  const gdal::Raster input(dem);
  const Grid<float> heights = gdal::read_band<float>(input, input.bands().front());
  for (const Scheme& scheme : test::sample_schemes()) {
    const std::string out = folder.file("out.tif");
    const int levels = scheme.mask().arity() > 2 ? 1 : 2;
    ASSERT_EQ(run_arete({"refine", dem, out, "--scheme", scheme.text(), "--levels",
                         std::to_string(levels), "--overwrite"})
                  .exit_code,
              0)
        << scheme.text();
    RefineOptions options;
    options.levels = levels;
    const gdal::Raster output(out);
    const Grid<float> expected = refine(heights, scheme, options);
    const Grid<float> actual = gdal::read_band<float>(output, output.bands().front());
    ASSERT_EQ(actual.extent(), expected.extent()) << scheme.text();
    EXPECT_TRUE(actual.samples() == expected.samples()) << scheme.text();
  }
}

// At 6378137 m a float32 has steps of half a metre.
TEST(cli_refine, geocentric_heights_in_float64_keep_their_millimetres) {
  const test::TemporaryFolder folder;
  constexpr double radius = 6378137;
  const auto height = [](int, Index r, Index c) {
    return radius + std::sin(static_cast<double>(3 * r + c));
  };
  Grid<double> above({12, 16});
  for (Index r = 0; r < above.rows(); ++r)
    for (Index c = 0; c < above.cols(); ++c) above(r, c) = height(1, r, c) - radius;
  RefineOptions options;
  options.levels = 3;
  for (const GDALDataType type : {GDT_Float64, GDT_Float32}) {
    test::RasterSpec spec;
    spec.type = type;
    test::make_raster(folder.file("in.tif"), spec, height);
    for (const char* scheme : {"gentle", "craggy", "b-spline:degree=3"}) {
      ASSERT_EQ(run_arete({"refine", folder.file("in.tif"), folder.file("out.tif"), "--scheme",
                           scheme, "--levels", "3", "--overwrite"})
                    .exit_code,
                0);
      const gdal::Raster output(folder.file("out.tif"));
      const gdal::BandInfo& band = output.bands().front();
      EXPECT_EQ(band.type, GDALGetDataTypeName(type)) << scheme;
      if (type == GDT_Float32) continue;
      const Grid<double> fine = gdal::read_band<double>(output, band);
      const Grid<double> truth = refine(above, parse_scheme(scheme), options);
      ASSERT_EQ(fine.extent(), truth.extent());
      for (Index r = 0; r < fine.rows(); ++r)
        for (Index c = 0; c < fine.cols(); ++c)
          ASSERT_NEAR(fine(r, c) - radius, truth(r, c), 1e-6) << scheme;
    }
  }
}

TEST(cli_refine, threads_do_not_change_a_byte_of_the_file) {
  const test::TemporaryFolder folder;
  std::set<std::string> files;
  for (const char* threads : {"1", "2", "5"}) {
    ASSERT_EQ(run_arete({"refine", dem, folder.file("out.tif"), "--scheme", "craggy", "--levels",
                         "3", "--threads", threads, "--overwrite"})
                  .exit_code,
              0);
    files.insert(bytes_of(folder.file("out.tif")));
  }
  EXPECT_EQ(files.size(), 1u);
}

TEST(cli_refine, a_different_scheme_along_y_is_used_along_y) {
  const test::TemporaryFolder folder;
  ASSERT_EQ(run_arete({"refine", dem, folder.file("out.tif"), "--scheme", "gentle", "--scheme-y",
                       "ternary-four-point"})
                .exit_code,
            0);
  const gdal::Raster output(folder.file("out.tif"));
  EXPECT_EQ(output.extent(), (Extent{3 * 343 + 1, 2 * 402 + 1}));
}

TEST(cli_refine, cells_keep_the_bounding_box) {
  const test::TemporaryFolder folder;
  const gdal::Raster input(dem);
  for (const char* scheme : {"chaikin", "gentle", "ternary-two-step"}) {
    ASSERT_EQ(run_arete({"refine", dem, folder.file("out.tif"), "--scheme", scheme, "--align",
                         "cells", "--overwrite"})
                  .exit_code,
              0);
    const gdal::Raster output(folder.file("out.tif"));
    const double factor = parse_scheme(scheme).mask().arity();
    EXPECT_NEAR(output.georeference()->affine[0], input.georeference()->affine[0], 1e-12);
    EXPECT_NEAR(output.georeference()->affine[3], input.georeference()->affine[3], 1e-12);
    EXPECT_NEAR(output.georeference()->affine[1] * factor, input.georeference()->affine[1], 1e-15);
    EXPECT_EQ(output.extent().cols, static_cast<Index>(factor) * 403);
  }
}

TEST(cli_refine, a_scheme_that_misses_the_cells_says_by_how_much) {
  const test::TemporaryFolder folder;
  const auto report = run_json({"refine", dem, folder.file("out.tif"), "--scheme",
                                "four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32", "--align",
                                "cells", "--json"});
  EXPECT_NE(report.at("misplacement").at("x"), 0);
}

TEST(cli_refine, vtk_files_of_all_three_forms_are_written_and_replaced) {
  const test::TemporaryFolder folder;
  for (const char* form : {"o.vti", "o.vts", "o.vtp"}) {
    const std::string out = folder.file(form);
    for (const char* scheme : {"gentle", "craggy"}) {
      const auto run = run_arete({"refine", dem, out, "--scheme", scheme, "--overwrite"});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      EXPECT_EQ(run.err, "");
    }
    const std::string bytes = bytes_of(out);
    EXPECT_EQ(bytes.rfind("<VTKFile", 0), 0u);
    EXPECT_NE(bytes.find("compressor="), std::string::npos);
    EXPECT_NE(bytes.find("</VTKFile>"), std::string::npos);
  }
  EXPECT_EQ(folder.entries(), 3);
}

// A long refinement that gets `signals`, `delay_ms` after its partial output is there.
test::Run disturbed(const test::TemporaryFolder& folder, const std::vector<int>& signals,
                    int delay_ms) {
  return run_arete({"refine", dem, folder.file("out.tif"), "--scheme", "gentle", "--levels", "6",
                    "--threads", "1"},
                   [&](int process) {
                     for (int wait = 0; folder.entries() == 0 && wait < 60'000; ++wait)
                       usleep(1000);
                     usleep(static_cast<useconds_t>(delay_ms) * 1000);
                     for (const int signal : signals) kill(process, signal);
                   });
}

TEST(cli_refine, interruption_leaves_no_file_behind) {
  for (const int delay_ms : {0, 30, 100, 400}) {
    const test::TemporaryFolder folder;
    const auto run = disturbed(folder, {SIGINT}, delay_ms);
    EXPECT_EQ(run.exit_code, 130) << run.err;
    EXPECT_EQ(run.err, "arete: interrupted; nothing was written\n");
    EXPECT_EQ(folder.entries(), 0);
  }
}

// A library that waits for ever would never let it see the first one.
TEST(cli_refine, a_second_interruption_ends_it_at_once_and_leaves_no_file_behind) {
  const test::TemporaryFolder folder;
  const auto run = disturbed(folder, {SIGINT, SIGTERM}, 30);
  // The system may deliver them in either order. It has no time for a word.
  EXPECT_TRUE(run.exit_code == 128 + SIGTERM || run.exit_code == 128 + SIGINT) << run.exit_code;
  EXPECT_EQ(run.err, "");
  EXPECT_EQ(folder.entries(), 0);
}

TEST(cli_refine, an_abort_leaves_no_file_behind_and_is_told) {
  const test::TemporaryFolder folder;
  const auto run = disturbed(folder, {SIGABRT}, 30);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_EQ(
      run.err,
      "arete: a library ended the program, what it said stands above; no output was written\n");
  EXPECT_EQ(folder.entries(), 0);
}

// Before the program listens, the signal ends it before it has made anything.
TEST(cli_refine, a_signal_at_the_very_start_leaves_nothing_either) {
  const test::TemporaryFolder folder;
  const auto run = run_arete({"refine", dem, folder.file("out.tif"), "--scheme", "gentle",
                              "--levels", "6", "--threads", "1"},
                             [](int process) { kill(process, SIGINT); });
  EXPECT_EQ(run.exit_code, 130) << run.err;
  EXPECT_EQ(folder.entries(), 0);
}

TEST(cli_refine, nothing_is_drawn_when_stderr_is_no_terminal) {
  const test::TemporaryFolder folder;
  const auto run =
      run_arete({"refine", dem, folder.file("out.tif"), "--scheme", "gentle", "--levels", "4"});
  EXPECT_EQ(run.err, "");
  EXPECT_NE(run.out.find("6433 x 5489"), std::string::npos) << run.out;
}

}  // namespace
}  // namespace arete

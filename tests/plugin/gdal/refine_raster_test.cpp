// SPDX-License-Identifier: MIT
#include "arete/gdal/refine_raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "arete/gdal/band_source.h"
#include "make_raster.h"
#include "support/fields.h"
#include "support/schemes.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using gdal::Raster;
using gdal::SampleType;

RefineOptions levels(int count, Alignment alignment = Alignment::nodes) {
  RefineOptions options;
  options.levels = count;
  options.alignment = alignment;
  return options;
}

void refine_file(const std::string& in, const std::string& out, const char* scheme,
                 const RefineOptions& options,
                 gdal::RasterOutput form = {SampleType::float64, {}}) {
  gdal::refine_raster(Raster(in), out, parse_scheme(scheme), parse_scheme(scheme), options, form,
                      {});
}

TEST(refine_raster, a_plane_planted_in_world_coordinates_is_found_again_in_its_place) {
  const test::TemporaryFolder folder;
  for (const bool rotated : {false, true}) {
    for (const bool point : {false, true}) {
      test::RasterSpec spec;
      spec.point = point;
      if (rotated) spec.affine = {500000, 24, 8, 4000000, 6, -28};
      const Georeference world{spec.affine, Registration::area};
      const std::string in = folder.file("plane.tif");
      test::make_raster(in, spec, [&](int, Index r, Index c) {
        const WorldPoint p = world.position(static_cast<double>(r), static_cast<double>(c));
        return 3 * (p.x - 500000) - 2 * (p.y - 4000000);
      });
      for (const char* scheme : {"gentle", "chaikin", "ternary-two-step",
                                 "four-parameter:lambda=3/32,mu=1/32,nu=1/4,omega=1/32",
                                 "three-point", "b-spline:degree=4"}) {
        for (const Alignment alignment : {Alignment::nodes, Alignment::cells}) {
          const std::string out = folder.file("fine.tif");
          refine_file(in, out, scheme, levels(2, alignment));
          // Read back by GDAL: size, origin and pixel size are what it says they are.
          const Raster fine(out);
          ASSERT_TRUE(fine.georeference());
          EXPECT_EQ(fine.georeference()->registration,
                    point ? Registration::point : Registration::area);
          EXPECT_FALSE(fine.crs().empty());
          const Grid<double> heights = gdal::read_band<double>(fine, fine.bands().front());
          for (Index r = 0; r < heights.rows(); ++r)
            for (Index c = 0; c < heights.cols(); ++c) {
              const WorldPoint p =
                  fine.georeference()->position(static_cast<double>(r), static_cast<double>(c));
              ASSERT_NEAR(heights(r, c), 3 * (p.x - 500000) - 2 * (p.y - 4000000), 1e-6)
                  << scheme << " rotated " << rotated << " point " << point;
            }
        }
      }
    }
  }
}

TEST(refine_raster, equals_the_engine_on_the_whole_grid_for_every_band_and_thread_count) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.extent = {70, 90};
  spec.bands = 3;
  spec.nodata = -32768;
  spec.type = GDT_Float32;
  std::vector<Grid<float>> truth;
  for (unsigned band = 0; band < 3; ++band) {
    truth.push_back(test::random_heights<float>(spec.extent, band));
    truth.back()(10, 20) = NAN;
  }
  test::make_raster(folder.file("in.tif"), spec, [&](int band, Index r, Index c) {
    const float value = truth[static_cast<std::size_t>(band - 1)](r, c);
    return std::isnan(value) ? -32768.0 : static_cast<double>(value);
  });
  const Scheme scheme = parse_scheme("gentle");
  for (const int threads : {1, 2, 0}) {
    RefineOptions options = levels(4);
    options.threads = threads;
    // The smallest memory that works makes the most pieces.
    gdal::refine_raster(Raster(folder.file("in.tif")), folder.file("out.tif"), scheme, scheme,
                        options, {SampleType::float32, {}, 40e6}, {});
    const Raster fine(folder.file("out.tif"));
    ASSERT_EQ(fine.bands().size(), 3u);
    for (std::size_t band = 0; band < 3; ++band) {
      EXPECT_EQ(fine.bands()[band].nodata, -32768);
      const Grid<float> expected = refine(truth[band], scheme, options);
      const Grid<float> actual = gdal::read_band<float>(fine, fine.bands()[band]);
      ASSERT_EQ(actual.extent(), expected.extent());
      for (std::size_t i = 0; i < expected.samples().size(); ++i)
        ASSERT_TRUE(actual.samples()[i] == expected.samples()[i] ||
                    (std::isnan(actual.samples()[i]) && std::isnan(expected.samples()[i])));
    }
  }
}

TEST(refine_raster, what_a_band_says_of_itself_is_carried) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.type = GDT_Int16;
  spec.nodata = -32767;
  {
    const auto dataset = test::make_raster(folder.file("in.tif"), spec, [](int, Index r, Index c) {
      return r == 0 && c == 0 ? -32767.0 : static_cast<double>(r * 3 + c);
    });
    GDALRasterBand* band = dataset->GetRasterBand(1);
    band->SetScale(0.5);
    band->SetOffset(100);
    band->SetUnitType("m");
    band->SetDescription("heights");
    band->SetMetadataItem("SENSOR", "lidar");
    band->SetMetadataItem("STATISTICS_MEAN", "7");
    dataset->SetMetadataItem("AUTHOR", "somebody");
  }
  refine_file(folder.file("in.tif"), folder.file("out.tif"), "four-point", levels(1),
              {SampleType::float32, {}});
  const Raster fine(folder.file("out.tif"));
  const gdal::BandInfo& band = fine.bands().front();
  EXPECT_EQ(band.type, "Float32");
  EXPECT_EQ(band.nodata, -32767);
  EXPECT_EQ(band.scale, 0.5);
  EXPECT_EQ(band.offset, 100);
  EXPECT_EQ(band.unit, "m");
  EXPECT_EQ(band.description, "heights");
  const auto has = [](const gdal::Metadata& metadata, const char* key) {
    return std::any_of(metadata.begin(), metadata.end(),
                       [&](const auto& item) { return item.first == key; });
  };
  EXPECT_TRUE(has(band.metadata, "SENSOR"));
  EXPECT_FALSE(has(band.metadata, "STATISTICS_MEAN"));
  EXPECT_TRUE(has(fine.metadata(), "AUTHOR"));
}

TEST(refine_raster, a_valid_result_never_reads_as_nodata) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.nodata = 0;
  // Crosses zero everywhere between its samples, but no sample is zero.
  test::make_raster(folder.file("in.tif"), spec,
                    [](int, Index r, Index c) { return (r + c) % 2 == 0 ? 1.0 : -1.0; });
  refine_file(folder.file("in.tif"), folder.file("out.tif"), "b-spline:degree=1", levels(1));
  const Raster fine(folder.file("out.tif"));
  const Grid<double> heights = gdal::read_band<double>(fine, fine.bands().front());
  for (const double value : heights.samples()) {
    EXPECT_FALSE(std::isnan(value));
    EXPECT_NE(value, 0);
  }
}

TEST(refine_raster, the_number_used_for_nodata_changes_no_valid_sample) {
  const test::TemporaryFolder folder;
  std::vector<Grid<double>> results;
  for (const double nodata : {-9999.0, 1e30, -3.4028234663852886e38}) {
    test::RasterSpec spec;
    spec.nodata = nodata;
    const Grid<double> heights = test::random_heights(spec.extent, 4);
    test::make_raster(folder.file("in.tif"), spec, [&](int, Index r, Index c) {
      return (r > 4 && r < 8 && c == 7) || (r == 0 && c < 4) ? nodata : heights(r, c);
    });
    refine_file(folder.file("in.tif"), folder.file("out.tif"), "gentle", levels(2));
    const Raster fine(folder.file("out.tif"));
    results.push_back(gdal::read_band<double>(fine, fine.bands().front()));
  }
  for (const Grid<double>& other : results)
    for (std::size_t i = 0; i < other.samples().size(); ++i)
      EXPECT_TRUE(other.samples()[i] == results[0].samples()[i] ||
                  (std::isnan(other.samples()[i]) && std::isnan(results[0].samples()[i])));
}

TEST(refine_raster, impossible_rasters_and_outputs_are_refused) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.nodata = 7;
  test::make_raster(folder.file("nothing.tif"), spec, [](int, Index, Index) { return 7; });
  const std::string out = folder.file("out.tif");
  EXPECT_THROW(refine_file(folder.file("nothing.tif"), out, "gentle", levels(1)),
               gdal::RasterError);
  spec.nodata.reset();
  test::make_raster(folder.file("in.tif"), spec, [](int, Index r, Index) { return r; });
  EXPECT_THROW(
      refine_file(folder.file("in.tif"), folder.file("no/such/folder.tif"), "gentle", levels(1)),
      gdal::RasterError);
  EXPECT_THROW(refine_file(folder.file("in.tif"), out, "gentle", levels(1),
                           {SampleType::float32, {"COMPRES=ZSTD"}}),
               gdal::RasterError);
  EXPECT_THROW(refine_file(folder.file("in.tif"), out, "gentle", levels(1),
                           {SampleType::float32, {"COMPRESS"}}),
               gdal::RasterError);
  EXPECT_THROW(refine_file(folder.file("in.tif"), out, "gentle", levels(28),
                           {SampleType::float32, {}, 1e13}),
               gdal::RasterError);
  EXPECT_THROW(
      refine_file(folder.file("in.tif"), out, "gentle", levels(8), {SampleType::float32, {}, 1e6}),
      gdal::RasterError);
}

TEST(refine_raster, one_sample_one_row_and_one_column_are_ordinary_inputs) {
  const test::TemporaryFolder folder;
  for (const Extent extent : {Extent{1, 1}, Extent{1, 9}, Extent{9, 1}}) {
    test::RasterSpec spec;
    spec.extent = extent;
    test::make_raster(folder.file("in.tif"), spec, [](int, Index r, Index c) { return 5 + r + c; });
    refine_file(folder.file("in.tif"), folder.file("out.tif"), "gentle", levels(2));
    const Raster fine(folder.file("out.tif"));
    EXPECT_EQ(fine.extent().rows, 4 * (extent.rows - 1) + 1);
    EXPECT_EQ(fine.extent().cols, 4 * (extent.cols - 1) + 1);
    const Grid<double> heights = gdal::read_band<double>(fine, fine.bands().front());
    EXPECT_EQ(heights(0, 0), 5);
  }
}

TEST(refine_raster, two_hundred_bands_are_refined_each_by_itself) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.extent = {5, 6};
  spec.bands = 200;
  const auto height = [](int band, Index r, Index c) { return 1000.0 * band + 4 * r + 8 * c; };
  test::make_raster(folder.file("in.tif"), spec, height);
  refine_file(folder.file("in.tif"), folder.file("out.tif"), "four-point", levels(1));
  const Raster fine(folder.file("out.tif"));
  ASSERT_EQ(fine.bands().size(), 200u);
  for (const gdal::BandInfo& band : fine.bands()) {
    const Grid<double> heights = gdal::read_band<double>(fine, band);
    for (Index r = 0; r < heights.rows(); ++r)
      for (Index c = 0; c < heights.cols(); ++c)
        ASSERT_NEAR(heights(r, c), 1000.0 * band.number + 2 * r + 4 * c, 0.1) << band.number;
  }
}

TEST(refine_raster, memory_does_not_grow_with_the_height_of_the_raster) {
  // Peak resident memory of this process, before and after a raster three times as tall.
  const auto peak = [] {
    std::ifstream status("/proc/self/status");
    std::string word;
    while (status >> word)
      if (word == "VmHWM:") break;
    double kilobytes = 0;
    status >> kilobytes;
    return kilobytes;
  };
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.type = GDT_Float32;
  const auto height = [](int, Index r, Index c) { return static_cast<double>((r * c) % 100); };
  // The lower result alone (79 MB) overflows GDAL's cache of 64 MB, the taller one is 158 MB more.
  spec.extent = {800, 100};
  test::make_raster(folder.file("low.tif"), spec, height);
  spec.extent = {2400, 100};
  test::make_raster(folder.file("tall.tif"), spec, height);
  const gdal::RasterOutput form{SampleType::float32, {"COMPRESS=NONE"}, 150e6};
  refine_file(folder.file("low.tif"), folder.file("out.tif"), "gentle", levels(4), form);
  const double low = peak();
  refine_file(folder.file("tall.tif"), folder.file("out.tif"), "gentle", levels(4), form);
  EXPECT_LT(peak() - low, 16e6 / 1024);
}

TEST(refine_raster, work_stops_when_the_progress_function_throws) {
  const test::TemporaryFolder folder;
  test::make_raster(folder.file("in.tif"), {}, [](int, Index r, Index) { return r; });
  struct Stop {};
  const Raster in(folder.file("in.tif"));
  const Scheme scheme = parse_scheme("gentle");
  EXPECT_THROW(gdal::refine_raster(in, folder.file("out.tif"), scheme, scheme, levels(3), {},
                                   [](double) { throw Stop(); }),
               Stop);
}

}  // namespace
}  // namespace arete

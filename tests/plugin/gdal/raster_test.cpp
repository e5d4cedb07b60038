// SPDX-License-Identifier: MIT
#include "arete/gdal/raster.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "arete/gdal/band_source.h"
#include "arete/gdal/reduced_band.h"
#include "make_raster.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

void expect_refused(const std::string& path, const char* part) {
  try {
    const gdal::Raster raster(path);
    ADD_FAILURE() << "opened " << path;
  } catch (const gdal::RasterError& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
  }
}

TEST(raster, bad_files_are_refused_with_name_and_remedy) {
  const test::TemporaryFolder folder;
  expect_refused(folder.file("absent.tif"), "does not exist");
  std::ofstream(folder.file("text.tif")) << "not a raster";
  expect_refused(folder.file("text.tif"), "not a raster that GDAL can read");
  std::ofstream(folder.file("empty.tif")).close();
  expect_refused(folder.file("empty.tif"), "not a raster that GDAL can read");
  test::RasterSpec spec;
  spec.type = GDT_CFloat32;
  test::make_raster(folder.file("complex.tif"), spec, [](int, Index, Index) { return 1; });
  expect_refused(folder.file("complex.tif"), "complex numbers");
  spec.type = GDT_Byte;
  {
    const auto dataset =
        test::make_raster(folder.file("palette.tif"), spec, [](int, Index, Index) { return 1; });
    GDALColorTable table;
    const GDALColorEntry red{255, 0, 0, 255};
    table.SetColorEntry(1, &red);
    dataset->GetRasterBand(1)->SetColorTable(&table);
  }
  expect_refused(folder.file("palette.tif"), "palette");
}

TEST(raster, a_file_cut_off_in_the_middle_says_which_row_is_missing) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("cut.tif");
  test::RasterSpec spec;
  spec.extent = {200, 200};
  test::make_raster(path, spec, [](int, Index r, Index c) { return static_cast<double>(r * c); });
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  const gdal::Raster raster(path);
  try {
    (void)gdal::read_band<float>(raster, raster.bands().front());
    ADD_FAILURE();
  } catch (const gdal::RasterError& error) {
    EXPECT_NE(std::string(error.what()).find("row "), std::string::npos) << error.what();
  }
}

// GDAL alone would try 2^199 times to find the last row.
TEST(raster, a_text_grid_cut_off_says_so_whichever_row_is_asked_for_first) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("cut.asc");
  std::ofstream text(path);
  text << "ncols 3\nnrows 200\nxllcorner 0\nyllcorner 0\ncellsize 1\n";
  for (int r = 0; r < 100; ++r) text << r << " 2 3\n";
  text.close();
  const gdal::Raster raster(path);
  const gdal::BandSource<float> rows(raster, raster.bands().front());
  std::vector<float> row(3);
  for (const Index asked : {199, 150}) try {
      rows.read(asked, row.data());
      ADD_FAILURE() << "read row " << asked;
    } catch (const gdal::RasterError& error) {
      EXPECT_NE(std::string(error.what()).find("row 100 "), std::string::npos) << error.what();
    }
  rows.read(99, row.data());
  EXPECT_EQ(row, (std::vector<float>{99, 2, 3}));
}

TEST(raster, a_block_beyond_the_memory_is_refused_before_gdal_decodes_it) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("claim.tif");
  gdal::register_formats();
  const char* options[] = {"SPARSE_OK=TRUE",    "TILED=YES",        "BLOCKXSIZE=400000",
                           "BLOCKYSIZE=400000", "COMPRESS=DEFLATE", nullptr};
  GDALClose(GetGDALDriverManager()->GetDriverByName("GTiff")->Create(
      path.c_str(), 400000, 400000, 1, GDT_Float64, const_cast<char**>(options)));
  EXPECT_LT(std::filesystem::file_size(path), 10000u);
  try {
    const gdal::Raster raster(path);
    FAIL() << "taken";
  } catch (const gdal::RasterError& error) {
    EXPECT_NE(std::string(error.what()).find("TILED=YES"), std::string::npos) << error.what();
  }
}

TEST(raster, nodata_masks_and_alpha_come_as_missing_samples) {
  const test::TemporaryFolder folder;
  const auto height = [](int, Index r, Index c) {
    return r == 2 && c == 3 ? -9999.0 : static_cast<double>(r + c);
  };
  test::RasterSpec spec;
  spec.nodata = -9999;
  test::make_raster(folder.file("nodata.tif"), spec, height);
  spec.nodata.reset();
  {
    const auto masked = test::make_raster(folder.file("mask.tif"), spec, height);
    masked->CreateMaskBand(GMF_PER_DATASET);
    std::vector<unsigned char> mask(12 * 16, 255);
    mask[2 * 16 + 3] = 0;
    ASSERT_EQ(masked->GetRasterBand(1)->GetMaskBand()->RasterIO(GF_Write, 0, 0, 16, 12, mask.data(),
                                                                16, 12, GDT_Byte, 0, 0, nullptr),
              CE_None);
  }
  spec.bands = 2;
  spec.type = GDT_Float32;
  spec.options = {"ALPHA=YES"};
  test::make_raster(folder.file("alpha.tif"), spec, [&](int band, Index r, Index c) {
    return band == 1 ? height(1, r, c) : (r == 2 && c == 3 ? 0 : 255);
  });
  for (const char* name : {"nodata.tif", "mask.tif", "alpha.tif"}) {
    const gdal::Raster raster(folder.file(name));
    ASSERT_EQ(raster.bands().size(), 1u) << name;
    const Grid<float> samples = gdal::read_band<float>(raster, raster.bands().front());
    for (Index r = 0; r < 12; ++r)
      for (Index c = 0; c < 16; ++c) {
        EXPECT_EQ(std::isnan(samples(r, c)), r == 2 && c == 3) << name;
        EXPECT_TRUE(std::isnan(samples(r, c)) || samples(r, c) == static_cast<float>(r + c));
      }
  }
}

TEST(raster, reduced_bands_are_means_of_valid_samples_in_their_place) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec;
  spec.extent = {9, 14};
  spec.nodata = -1;
  // A plane in world coordinates, so that every mean must equal the height at its own place.
  const Georeference world{spec.affine, Registration::area};
  const auto height = [&](int, Index r, Index c) {
    const WorldPoint p = world.position(static_cast<double>(r), static_cast<double>(c));
    return r == 8 ? -1 : (p.x - 500000) + 2 * (p.y - 4000000);
  };
  test::make_raster(folder.file("plane.tif"), spec, height);
  const gdal::Raster raster(folder.file("plane.tif"));
  const gdal::ReducedBand reduced = gdal::read_reduced_band(raster, raster.bands().front(), 5);
  EXPECT_EQ(reduced.factor, 3);
  ASSERT_EQ(reduced.samples.extent(), (Extent{3, 4}));
  for (Index r = 0; r < 2; ++r)
    for (Index c = 0; c < 4; ++c) {
      const WorldPoint p =
          reduced.georeference.position(static_cast<double>(r), static_cast<double>(c));
      EXPECT_NEAR(reduced.samples(r, c), (p.x - 500000) + 2 * (p.y - 4000000), 1e-3);
    }
}

}  // namespace
}  // namespace arete

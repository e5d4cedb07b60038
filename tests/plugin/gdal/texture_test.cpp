// SPDX-License-Identifier: MIT
#include "arete/gdal/texture.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "make_raster.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using gdal::DrapeBox;
using gdal::TextureImage;

/// A box of 40 x 30 samples at 10 m in UTM zone 16.
DrapeBox utm_box() {
  OGRSpatialReference reference;
  reference.SetFromUserInput("EPSG:32616");
  char* text = nullptr;
  reference.exportToWkt(&text);
  DrapeBox box{{30, 40}, {{500000, 10, 0, 4000000, 0, -10}, Registration::area}, text, true};
  CPLFree(text);
  return box;
}

/// Red grows eastwards, green southwards, over the whole picture; blue is level.
double ramp(const test::RasterSpec& spec, int band, Index row, Index col) {
  if (band == 1)
    return 250.0 * static_cast<double>(col) / static_cast<double>(spec.extent.cols - 1);
  if (band == 2)
    return 250.0 * static_cast<double>(row) / static_cast<double>(spec.extent.rows - 1);
  return band == 3 ? 77 : 255;
}

std::string make_picture(const test::TemporaryFolder& folder, const std::string& name,
                         test::RasterSpec spec) {
  spec.type = GDT_Byte;
  test::make_raster(folder.file(name), spec,
                    [&](int band, Index row, Index col) { return ramp(spec, band, row, col); });
  return folder.file(name);
}

test::RasterSpec over_box(int bands = 3) {
  test::RasterSpec spec;
  spec.extent = {60, 80};
  spec.affine = {500000, 5, 0, 4000000, 0, -5};
  spec.bands = bands;
  return spec;
}

int red(const TextureImage& image, double x, double y) {
  const int col = static_cast<int>(x * image.width);
  const int row = static_cast<int>(y * image.height);
  return image.rgb[3 * static_cast<std::size_t>(row * image.width + col)];
}
int opacity(const TextureImage& image, double x, double y) {
  const int col = static_cast<int>(x * image.width);
  const int row = static_cast<int>(y * image.height);
  return image.opacity[static_cast<std::size_t>(row * image.width + col)];
}

std::string refusal(const std::string& path, const DrapeBox& box) {
  try {
    static_cast<void>(gdal::read_texture(path, box, 1000));
  } catch (const gdal::RasterError& error) {
    return error.what();
  }
  return "";
}

TEST(texture, a_picture_on_the_box_comes_as_it_is) {
  const test::TemporaryFolder folder;
  const auto spec = over_box();
  const TextureImage image =
      gdal::read_texture(make_picture(folder, "a.tif", spec), utm_box(), 1000);
  EXPECT_TRUE(image.draped);
  ASSERT_EQ(image.width, 80);
  ASSERT_EQ(image.height, 60);
  EXPECT_TRUE(image.opacity.empty()) << "it is everywhere";
  for (Index row = 0; row < 60; ++row) {
    for (Index col = 0; col < 80; ++col) {
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(image.rgb[static_cast<std::size_t>(3 * (row * 80 + col) + c)],
                    ramp(spec, c + 1, row, col), 1);
      }
    }
  }
}

TEST(texture, half_a_picture_covers_half_of_the_box) {
  const test::TemporaryFolder folder;
  auto spec = over_box();
  spec.affine[0] += 200;  // its western edge is the middle of the box
  const TextureImage image =
      gdal::read_texture(make_picture(folder, "a.tif", spec), utm_box(), 1000);
  ASSERT_FALSE(image.opacity.empty());
  EXPECT_EQ(opacity(image, 0.45, 0.5), 0);
  EXPECT_EQ(opacity(image, 0.55, 0.5), 255);
  EXPECT_NEAR(red(image, 0.51, 0.5), 3, 3) << "and begins with its own western edge";
}

TEST(texture, another_reference_system_is_warped_to_the_same_place) {
  const test::TemporaryFolder folder;
  auto spec = over_box();
  // The box's corners are near longitude -87; half a pixel of 5 m is 4.5e-5 degrees.
  const double lat = 36.14;
  spec.crs = "EPSG:4326";
  spec.extent = {200, 200};
  spec.affine = {-87.01, 1e-4, 0, lat + 0.01, 0, -1e-4};
  const TextureImage image =
      gdal::read_texture(make_picture(folder, "a.tif", spec), utm_box(), 1000);
  EXPECT_TRUE(image.draped);
  // What PROJ says about the middle of the box, by another way than the warp.
  OGRSpatialReference utm, geographic;
  utm.SetFromUserInput("EPSG:32616");
  geographic.SetFromUserInput("EPSG:4326");
  geographic.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
  const std::unique_ptr<OGRCoordinateTransformation> there(
      OGRCreateCoordinateTransformation(&utm, &geographic));
  double x = 500200;
  double y = 4000000 - 150;
  ASSERT_TRUE(there->Transform(1, &x, &y));
  const double column = (x + 87.01) / 1e-4;
  EXPECT_NEAR(red(image, 0.5, 0.5), 250 * column / 199, 2);
}

TEST(texture, a_turned_terrain_turns_the_picture) {
  const test::TemporaryFolder folder;
  const std::string path = make_picture(folder, "a.tif", over_box());
  DrapeBox box = utm_box();
  box.extent = {40, 30};
  box.georeference.affine = {500000, 0, 10, 4000000, -10, 0};  // rows go east, columns south
  const TextureImage image = gdal::read_texture(path, box, 1000);
  EXPECT_EQ(image.width, 60);
  EXPECT_EQ(image.height, 80);
  EXPECT_LT(red(image, 0.9, 0.1), 40) << "row 0 is the west";
  EXPECT_GT(red(image, 0.1, 0.9), 210);
}

TEST(texture, without_a_place_or_on_request_it_is_stretched) {
  const test::TemporaryFolder folder;
  auto spec = over_box();
  spec.affine[0] += 1e6;
  const std::string elsewhere = make_picture(folder, "a.tif", spec);
  EXPECT_FALSE(gdal::read_texture(elsewhere, utm_box(), 1000, true).draped);
  DrapeBox nowhere = utm_box();
  nowhere.referenced = false;
  const TextureImage image = gdal::read_texture(elsewhere, nowhere, 1000);
  EXPECT_FALSE(image.draped);
  EXPECT_EQ(image.width, 80);
  EXPECT_LT(red(image, 0.01, 0.5), 10);
  EXPECT_GT(red(image, 0.99, 0.5), 240);
}

TEST(texture, large_pictures_are_averaged_down_not_thinned_out) {
  const test::TemporaryFolder folder;
  test::RasterSpec spec = over_box(1);
  spec.extent = {600, 800};
  spec.affine = {500000, 0.5, 0, 4000000, 0, -0.5};
  spec.type = GDT_Byte;
  test::make_raster(folder.file("c.tif"), spec,
                    [](int, Index row, Index col) { return (row + col) % 2 == 0 ? 0 : 200; });
  for (const bool stretch : {false, true}) {
    const TextureImage image = gdal::read_texture(folder.file("c.tif"), utm_box(), 100, stretch);
    EXPECT_EQ(image.width, 100);
    EXPECT_EQ(image.height, 75);
    for (const std::uint8_t value : image.rgb) EXPECT_NEAR(value, 100, 12);
  }
}

TEST(texture, grey_palette_and_alpha_are_pictures_too) {
  const test::TemporaryFolder folder;
  const TextureImage grey =
      gdal::read_texture(make_picture(folder, "g.tif", over_box(1)), utm_box(), 1000);
  EXPECT_EQ(grey.rgb[3 * 40], grey.rgb[3 * 40 + 2]) << "one band for all channels";

  auto spec = over_box(4);
  spec.type = GDT_Byte;
  spec.options = {"ALPHA=YES"};
  test::make_raster(folder.file("t.tif"), spec, [&](int band, Index row, Index col) {
    return band == 4 ? (col < 40 ? 0 : 255) : ramp(spec, band, row, col);
  });
  for (const bool stretch : {false, true}) {
    const TextureImage clear = gdal::read_texture(folder.file("t.tif"), utm_box(), 1000, stretch);
    EXPECT_EQ(opacity(clear, 0.2, 0.5), 0);
    EXPECT_EQ(opacity(clear, 0.8, 0.5), 255);
  }

  auto indexed = over_box(1);
  indexed.type = GDT_Byte;
  {
    const auto dataset = test::make_raster(folder.file("p.tif"), indexed,
                                           [](int, Index, Index col) { return col < 40 ? 0 : 1; });
    GDALColorTable table;
    const GDALColorEntry first{10, 20, 30, 255};
    const GDALColorEntry second{200, 100, 50, 255};
    table.SetColorEntry(0, &first);
    table.SetColorEntry(1, &second);
    dataset->GetRasterBand(1)->SetColorTable(&table);
  }
  const TextureImage colors = gdal::read_texture(folder.file("p.tif"), utm_box(), 1000);
  EXPECT_EQ(red(colors, 0.2, 0.5), 10);
  EXPECT_EQ(red(colors, 0.8, 0.5), 200);
}

TEST(texture, what_is_no_picture_or_lies_elsewhere_is_refused_with_a_remedy) {
  const test::TemporaryFolder folder;
  const auto names = [&](const std::string& path, std::initializer_list<const char*> words) {
    const std::string text = refusal(path, utm_box());
    EXPECT_NE(text.find(path), std::string::npos) << text;
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
  };
  names(folder.file("none.png"), {"does not exist"});
  std::ofstream(folder.file("empty.png")).flush();
  names(folder.file("empty.png"), {"not a picture"});
  std::ofstream(folder.file("text.jpg")) << "words";
  names(folder.file("text.jpg"), {"not a picture"});

  auto spec = over_box();
  spec.affine[0] += 1e6;
  names(make_picture(folder, "far.tif", spec), {"beside the terrain", "--stretch"});
  spec.crs = "";
  names(make_picture(folder, "vague.tif", spec), {"beside the terrain", "no reference system"});
  auto wide = over_box();
  wide.type = GDT_UInt16;
  test::make_raster(folder.file("wide.tif"), wide, [](int, Index, Index) { return 1000; });
  names(folder.file("wide.tif"), {"UInt16", "gdal_translate"});
}

TEST(texture, damaged_pictures_are_refused_and_not_half_read) {
  const test::TemporaryFolder folder;
  const std::string whole = make_picture(folder, "a.tif", over_box());
  GDALDataset* source = GDALDataset::Open(whole.c_str());
  for (const char* driver : {"PNG", "JPEG"}) {
    const std::string path = folder.file(std::string("cut.") + driver);
    GDALClose(GetGDALDriverManager()->GetDriverByName(driver)->CreateCopy(
        path.c_str(), source, FALSE, nullptr, nullptr, nullptr));
    std::filesystem::remove(path + ".aux.xml");
    std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
    const std::string text = refusal(path, utm_box());
    EXPECT_NE(text.find("damaged"), std::string::npos) << driver << ": " << text;
  }
  GDALClose(source);
}

TEST(texture, a_picture_without_pixels_is_refused) {
  const test::TemporaryFolder folder;
  // The header of a PNG of width 0.
  const std::string bytes("\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\0\0\0\0\0\x08\x02\0\0\0\0\0\0\0",
                          33);
  std::ofstream(folder.file("zero.png"), std::ios::binary) << bytes;
  EXPECT_NE(refusal(folder.file("zero.png"), utm_box()), "");
}

}  // namespace
}  // namespace arete

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "arete/gdal/band_source.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

TEST(cli_render, draws_a_picture_of_the_asked_size_without_a_display) {
  const test::TemporaryFolder folder;
  for (const char* view : {"oblique", "map"}) {
    const auto report = test::run_json({"render", test::dem, folder.file("out.png"), "--size",
                                        "320x240", "--view", view, "--overwrite", "--json"});
    EXPECT_EQ(report.at("width"), 320);
    const gdal::Raster picture(folder.file("out.png"));
    EXPECT_EQ(picture.extent(), (Extent{240, 320}));
    // Neither blank nor black: many shades, and terrain green among them.
    const Grid<float> red = gdal::read_band<float>(picture, picture.bands()[0]);
    const Grid<float> green = gdal::read_band<float>(picture, picture.bands()[1]);
    int greenish = 0;
    for (std::size_t i = 0; i < red.samples().size(); ++i)
      if (green.samples()[i] > red.samples()[i] + 10) ++greenish;
    EXPECT_GT(greenish, 320 * 240 / 10) << view;
  }
}

TEST(cli_render, more_light_from_the_other_side_is_another_picture) {
  const test::TemporaryFolder folder;
  std::vector<double> sums;
  for (const char* light : {"315,40", "135,40", "315,80"}) {
    ASSERT_EQ(test::run_arete({"render", test::dem, folder.file("o.png"), "--size", "200x150",
                               "--light", light, "--overwrite"})
                  .exit_code,
              0);
    const gdal::Raster picture(folder.file("o.png"));
    double sum = 0;
    const Grid<float> red = gdal::read_band<float>(picture, picture.bands()[0]);
    for (std::size_t i = 0; i < red.samples().size(); ++i)
      sum += red.samples()[i] * static_cast<double>(i % 97);
    sums.push_back(sum);
  }
  EXPECT_NE(sums[0], sums[1]);
  EXPECT_NE(sums[0], sums[2]);
}

}  // namespace
}  // namespace arete

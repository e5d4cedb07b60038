// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

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

TEST(cli_render, the_unit_is_that_of_the_band_or_of_the_option_and_never_a_guess) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("unknown.asc"))
      << "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 1\n1 2 3\n2 3 4\n3 4 7\n";
  std::ofstream(folder.file("feet.vrt"))
      << R"(<VRTDataset rasterXSize="3" rasterYSize="3"><GeoTransform>0,1,0,3,0,-1</GeoTransform>)"
      << R"(<VRTRasterBand dataType="Float32" band="1"><UnitType>ft</UnitType><SimpleSource>)"
      << R"(<SourceFilename relativeToVRT="1">unknown.asc</SourceFilename><SourceBand>1</SourceBand>)"
      << "</SimpleSource></VRTRasterBand></VRTDataset>\n";
  const auto units = [&](const char* input, const test::Arguments& options) {
    test::Arguments arguments{"render", folder.file(input), folder.file("o.png"),
                              "--size", "200x150",          "--overwrite",
                              "--json"};
    arguments.insert(arguments.end(), options.begin(), options.end());
    return test::run_json(arguments).at("units").get<std::string>();
  };
  EXPECT_EQ(units("unknown.asc", {}), "");
  EXPECT_EQ(units("feet.vrt", {}), "ft");
  EXPECT_EQ(units("unknown.asc", {"--units", "yd"}), "yd");
  EXPECT_EQ(units("feet.vrt", {"--units", "yd"}), "yd");
}

std::string render_error(const test::Arguments& options, int exit_code = 1) {
  const test::TemporaryFolder folder;
  test::Arguments arguments{"render", test::dem, folder.file("o.png"), "--max-samples", "50"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  const test::Run run = test::run_arete(arguments);
  EXPECT_EQ(run.exit_code, exit_code) << run.err;
  EXPECT_EQ(folder.entries(), 0) << "nothing is left behind";
  EXPECT_EQ(run.out, "");
  return run.err;
}

TEST(cli_render, a_wrong_option_is_named_with_what_is_right) {
  const auto names = [](const test::Arguments& options, const char* what) {
    const std::string text = render_error(options, 2);
    EXPECT_NE(text.find(what), std::string::npos) << text;
  };
  names({"--light", "north"}, "315,40");
  names({"--light", "315,95"}, "elevation");
  names({"--light", "315,40,1,red"}, "315,40,0.8,#ffe0b0");
  names({"--camera", "high"}, "210,30");
  names({"--size", "big"}, "1600x1000");
  names({"--background", "white"}, "#ffe0b0");
  names({"--ambient", "2"}, "--ambient");
  names({"--palette", "plaid"}, "alpine");
  names({"--palette", "alpine", "--colormap", "gray"}, "one of them");
  names({"--range", "high"}, "200:1800");
  names({"--view", "map", "--turntable", "4"}, "--turntable");
  names({"--levels", "2"}, "--scheme");
}

TEST(cli_render, every_flaw_of_a_palette_is_named_with_its_place) {
  const test::TemporaryFolder folder;
  const std::string path = folder.file("p.json");
  const auto names = [&](const std::string& json, std::initializer_list<const char*> words) {
    std::ofstream(path) << json;
    const std::string text = render_error({"--palette", path});
    EXPECT_NE(text.find("p.json"), std::string::npos) << text;
    for (const char* word : words) EXPECT_NE(text.find(word), std::string::npos) << text;
    EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 1) << text;
  };
  const std::string grass = R"({"name": "grass", "color": "#00ff00"})";
  const auto layer = [&](const std::string& keys) {
    return R"({"layers": [)" + grass + R"(, {"color": [1, 2, 3], )" + keys + "}]}";
  };
  names("", {"not JSON"});
  names("{\"layers\": [", {"not JSON", "line 1"});
  names("{\"layers\": 1e999}", {"not JSON", "1e999"});
  names("[]", {"the file must be an object"});
  names("{}", {"layers must be a list"});
  names(R"({"layers": []})", {"layers must be a list"});
  names(R"({"layers": [3]})", {"layers[0] must be an object"});
  names(R"({"layer": []})", {"layer is no key", "layers"});
  names(R"({"heights": "metres", "layers": []})", {"heights", "\"relative\"", "\"absolute\""});
  names(R"({"layers": [{}]})", {"layers[0].color is missing"});
  names(R"({"layers": [{"color": "green"}]})", {"layers[0].color", "#rrggbb"});
  names(R"({"layers": [{"color": [1, 2, 256]}]})", {"layers[0].color"});
  names(R"({"layers": [{"color": [1, 2, 2.5]}]})", {"layers[0].color"});
  names(layer(R"("opacity": 2)"), {"layers[1].opacity must be from 0 to 1"});
  names(layer(R"("opacity": "full")"), {"layers[1].opacity must be a number"});
  names(layer(R"("hight": {"from": 1})"), {"layers[1].hight is no key", "height"});
  names(layer(R"("height": 3)"), {"layers[1].height must be an object"});
  names(layer(R"("height": {})"), {"layers[1].height needs"});
  names(layer(R"("height": {"from": 2, "to": 1})"), {"layers[1].height.from"});
  names(layer(R"("slope": {"from": 2, "width": 1})"), {"layers[1].slope.width is no key"});
  names(layer(R"("slope": {"from": 2, "fade": -1})"), {"layers[1].slope.fade"});
  names(layer(R"("aspect": {"from": 300})"), {"layers[1].aspect needs", "to"});
  EXPECT_NE(render_error({"--palette", folder.file("none.json")}).find("none.json"),
            std::string::npos);
}

TEST(cli_render, a_palette_file_colours_the_picture) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("p.json")) << R"({"name": "test", "heights": "absolute", "layers": [
              {"name": "low", "color": "#00c800"},
              {"name": "high", "color": [200, 0, 0], "height": {"from": 500, "fade": 20}}]})";
  ASSERT_EQ(test::run_arete({"render", test::dem, folder.file("o.png"), "--size", "200x150",
                             "--palette", folder.file("p.json"), "--view", "map", "--no-color-bar"})
                .exit_code,
            0);
  const gdal::Raster picture(folder.file("o.png"));
  const Grid<float> red = gdal::read_band<float>(picture, picture.bands()[0]);
  const Grid<float> green = gdal::read_band<float>(picture, picture.bands()[1]);
  int reddish = 0;
  int greenish = 0;
  for (std::size_t i = 0; i < red.samples().size(); ++i) {
    if (red.samples()[i] > 2 * green.samples()[i] + 20) ++reddish;
    if (green.samples()[i] > 2 * red.samples()[i] + 20) ++greenish;
  }
  EXPECT_GT(reddish, 2000);
  EXPECT_GT(greenish, 2000);
}

TEST(cli_render, a_refined_picture_is_of_the_refined_samples) {
  const test::TemporaryFolder folder;
  const auto report = test::run_json({"render", test::dem, folder.file("o.png"), "--size",
                                      "200x150", "--scheme", "gentle", "--levels", "1", "--json"});
  EXPECT_EQ(report.at("cols_drawn"), 2 * 403 - 1);
  EXPECT_EQ(report.at("rows_drawn"), 2 * 344 - 1);
}

TEST(cli_render, a_turntable_gives_all_its_frames_or_none) {
  const test::TemporaryFolder folder;
  const test::Arguments arguments{"render",      test::dem, folder.file("o.png"), "--size", "64x64",
                                  "--turntable", "3",       "--max-samples",      "100"};
  ASSERT_EQ(test::run_arete(arguments).exit_code, 0);
  EXPECT_EQ(folder.entries(), 3);
  for (const char* name : {"o-000.png", "o-001.png", "o-002.png"})
    EXPECT_EQ(gdal::Raster(folder.file(name)).extent(), (Extent{64, 64}));
  // One of them in the way: none is touched.
  const test::TemporaryFolder second;
  std::ofstream(second.file("o-001.png")) << "mine";
  test::Arguments blocked = arguments;
  blocked[2] = second.file("o.png");
  const test::Run run = test::run_arete(blocked);
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("o-001.png exists"), std::string::npos) << run.err;
  EXPECT_EQ(second.entries(), 1);
}

TEST(cli_render, models_come_whole_and_say_what_they_are) {
  const test::TemporaryFolder folder;
  const auto glb = test::run_json({"render", test::dem, folder.file("o.glb"), "--max-samples",
                                   "100", "--palette", "alpine", "--json"});
  EXPECT_EQ(glb.at("averaged"), 5);
  EXPECT_EQ(glb.at("exaggeration"), 1);
  EXPECT_EQ(glb.at("vertices"), 80 * 68);
  EXPECT_EQ(glb.at("quads"), 79 * 67);
  EXPECT_EQ(folder.entries(), 1);
  const auto obj =
      test::run_json({"render", test::dem, folder.file("m.obj"), "--max-samples", "100", "--json"});
  EXPECT_EQ(obj.at("texture").at("width"), 80);
  EXPECT_EQ(folder.entries(), 4) << ".obj, .mtl, .png";
  // Something of the same name in the way of one of the three: nothing new appears.
  std::filesystem::remove(folder.file("m.obj"));
  const test::Run run = test::run_arete({"render", test::dem, folder.file("m.obj")});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("m.mtl exists"), std::string::npos) << run.err;
  EXPECT_EQ(folder.entries(), 3);
  EXPECT_EQ(test::run_arete({"render", test::dem, folder.file("a b.obj")}).exit_code, 2);
  EXPECT_EQ(test::run_arete({"render", test::dem, folder.file("o.gltf")}).exit_code, 2);
}

TEST(cli_render, refine_makes_the_model_that_render_makes) {
  const test::TemporaryFolder folder;
  const std::string coarse = folder.file("coarse.tif");
  ASSERT_EQ(
      std::system(("gdal_translate -q -srcwin 40 40 60 50 " + test::dem + " " + coarse).c_str()),
      0);
  const auto bytes = [&](const char* name) {
    std::ifstream stream(folder.file(name), std::ios::binary);
    return std::string{std::istreambuf_iterator<char>(stream), {}};
  };
  // A grey picture of the ground, half as fine as the DEM.
  const std::string picture = folder.file("t.tif");
  ASSERT_EQ(std::system(("gdal_translate -q -ot Byte -scale 200 1100 100 255 -outsize 50% 50% " +
                         test::dem + " " + picture)
                            .c_str()),
            0);
  // The names of the models are those of the files.
  std::filesystem::create_directory(folder.file("a"));
  std::filesystem::create_directory(folder.file("b"));
  // The binary part holds positions, normals, texture coordinates, triangles and the picture.
  const auto binary = [&](const char* name) {
    const std::string glb = bytes(name);
    std::uint32_t json = 0;
    std::memcpy(&json, glb.data() + 12, 4);
    return glb.substr(20 + json);
  };
  std::vector<std::string> models;
  for (const test::Arguments& look :
       {test::Arguments{"--palette", "alpine"}, test::Arguments{"--texture", picture}}) {
    const auto made = [&](const char* verb, const char* name) {
      test::Arguments arguments{verb,       coarse, folder.file(name), "--scheme",   "gentle",
                                "--levels", "2",    "--json",          "--overwrite"};
      arguments.insert(arguments.end(), look.begin(), look.end());
      return test::run_json(arguments);
    };
    (void)made("render", "a/m.glb");
    EXPECT_EQ(made("refine", "b/m.glb").at("rows"), 4 * 49 + 1);
    models.push_back(binary("b/m.glb"));
    ASSERT_GT(models.back().size(), 197 * 237 * 32u);
    EXPECT_TRUE(binary("a/m.glb") == models.back()) << look.front();
  }
  EXPECT_FALSE(models[0] == models[1]) << "the picture is not laid";
  EXPECT_EQ(test::run_arete({"refine", coarse, folder.file("o.tif"), "--scheme", "gentle",
                             "--palette", "alpine"})
                .exit_code,
            2);
}

TEST(cli_render, a_texture_is_laid_by_its_place_on_earth) {
  const test::TemporaryFolder folder;
  // The DEM's own eastern half as a grey picture.
  const gdal::Raster raster(test::dem);
  const auto place = raster.place().affine;
  const auto edge = [&](double col) { return std::to_string(place[0] + col * place[1]); };
  const std::string bounds = edge(201.5) + " " + std::to_string(place[3]) + " " + edge(403) + " " +
                             std::to_string(place[3] + 344 * place[5]);
  const std::string command = "gdal_translate -q -ot Byte -scale 200 1100 100 255 -projwin " +
                              bounds + " " + test::dem + " " + folder.file("t.tif");
  ASSERT_EQ(std::system(command.c_str()), 0);
  const auto draw = [&](bool stretch) {
    test::Arguments arguments{"render",
                              test::dem,
                              folder.file("o.png"),
                              "--texture",
                              folder.file("t.tif"),
                              "--view",
                              "map",
                              "--size",
                              "300x250",
                              "--colormap",
                              "viridis",
                              "--overwrite"};
    if (stretch) arguments.push_back("--stretch");
    const test::Run run = test::run_arete(arguments);
    EXPECT_EQ(run.exit_code, 0) << run.err;
    const gdal::Raster picture(folder.file("o.png"));
    return std::pair{gdal::read_band<float>(picture, picture.bands()[0]),
                     gdal::read_band<float>(picture, picture.bands()[2])};
  };
  // Grey has as much blue as red (the light is a little warm); viridis has none such.
  const auto grey = [](const auto& picture, Index from, Index to) {
    int count = 0;
    for (Index r = 60; r < 190; ++r)
      for (Index c = from; c < to; ++c)
        count += std::abs(picture.first(r, c) - picture.second(r, c)) < 20 ? 1 : 0;
    return count / (130.0 * static_cast<double>(to - from));
  };
  const auto draped = draw(false);
  EXPECT_GT(grey(draped, 160, 250), 0.98) << "the picture in the east";
  EXPECT_LT(grey(draped, 50, 140), 0.3) << "the colours of the heights in the west";
  const auto stretched = draw(true);
  EXPECT_GT(grey(stretched, 50, 140), 0.98);
}

TEST(cli_render, a_texture_that_cannot_be_laid_leaves_nothing_behind) {
  const test::TemporaryFolder folder;
  EXPECT_NE(render_error({"--texture", folder.file("none.png")}).find("none.png"),
            std::string::npos);
  std::ofstream(folder.file("empty.png")).flush();
  EXPECT_NE(render_error({"--texture", folder.file("empty.png")}).find("empty.png"),
            std::string::npos);
  const std::string command = "gdal_translate -q -ot Byte -a_srs EPSG:32616 -a_ullr 0 100 100 0 " +
                              test::dem + " " + folder.file("far.tif");
  ASSERT_EQ(std::system(command.c_str()), 0);
  EXPECT_NE(render_error({"--texture", folder.file("far.tif")}).find("--stretch"),
            std::string::npos);
}

}  // namespace
}  // namespace arete

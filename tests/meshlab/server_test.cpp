// SPDX-License-Identifier: GPL-3.0-or-later
// The shipped script, filter by filter, in the distribution's meshlabserver. Its exit code says
// little, so the files it writes are read.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

#include "arete/refine/refiner.h"
#include "arete/reverse/grid_reverse.h"
#include "arete/scheme/catalogue.h"
#include "support/temporary_folder.h"

namespace arete::meshlab {
namespace {

const std::string source = ARETE_SOURCE_DIR;
const std::string terrain = source + "/meshlab-filters/terrain.ply";

std::string text_of(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

// Runs meshlabserver; what it says on both streams.
std::string serve(const std::string& arguments, const test::TemporaryFolder& folder) {
  const std::string log = folder.file("log");
  const std::string command = "XDG_RUNTIME_DIR=" + folder.path().string() +
                              " HOME=" + folder.path().string() + " " + source +
                              "/tests/support/with_display " + source +
                              "/scripts/try-meshlab --build " ARETE_BUILD_DIR " --server " +
                              arguments + " > " + log + " 2>&1";
  (void)!std::system(command.c_str());
  return text_of(log);
}

// The block of one filter of the shipped script as a script of its own.
std::string script_of(const std::string& filter, const test::TemporaryFolder& folder) {
  const std::string all = text_of(source + "/examples/terrain.mlx");
  const auto begin = all.find("<filter name=\"" + filter + "\">");
  const auto end = all.find("</filter>", begin);
  EXPECT_NE(end, std::string::npos) << filter;
  const std::string path = folder.file("script.mlx");
  std::ofstream(path) << "<!DOCTYPE FilterScript>\n<FilterScript>\n"
                      << all.substr(begin, end + 9 - begin) << "\n</FilterScript>\n";
  return path;
}

struct Vertices {
  std::size_t faces = 0;
  std::vector<std::vector<float>> rows;  // x y z ...
};

// MeshLab's binary PLY with float properties only.
Vertices read_binary_ply(const std::string& path) {
  std::ifstream stream(path, std::ios::binary);
  Vertices result;
  std::string line;
  std::size_t count = 0, properties = 0;
  bool in_vertices = false;
  while (std::getline(stream, line) && line != "end_header") {
    std::istringstream words(line);
    std::string word, kind;
    words >> word >> kind;
    if (word == "element") {
      in_vertices = kind == "vertex";
      words >> (in_vertices ? count : result.faces);
    }
    if (word == "property" && in_vertices) {
      EXPECT_EQ(kind, "float");
      ++properties;
    }
  }
  result.rows.assign(count, std::vector<float>(properties));
  for (auto& row : result.rows)
    stream.read(reinterpret_cast<char*>(row.data()), std::streamsize(properties * sizeof(float)));
  EXPECT_TRUE(bool(stream)) << path;
  return result;
}

constexpr Extent terrain_extent{43, 50};

Grid<double> terrain_heights() {
  std::ifstream stream(terrain);
  std::string line;
  while (std::getline(stream, line) && line != "end_header") {
  }
  Grid<double> heights(terrain_extent);
  for (double& z : heights.samples()) {
    double x = 0, y = 0;
    float height = 0;
    stream >> x >> y >> height;
    std::getline(stream, line);
    z = height;
  }
  return heights;
}

std::multiset<float> heights_in(const Vertices& vertices) {
  std::multiset<float> heights;
  for (const auto& row : vertices.rows) heights.insert(row[2]);
  return heights;
}

std::multiset<float> rounded(const Grid<double>& grid) {
  std::multiset<float> heights;
  for (double z : grid.samples()) heights.insert(static_cast<float>(z));
  return heights;
}

TEST(server, subdivide_by_the_shipped_script) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.ply");
  const std::string log = serve(
      "-i " + terrain + " -o " + out + " -s " + script_of("Arete: Subdivide Terrain Grid", folder),
      folder);
  const Vertices result = read_binary_ply(out);
  EXPECT_EQ(result.faces, 2u * 168 * 196) << log;
  RefineOptions options;
  options.levels = 2;
  options.detail.emplace();
  options.detail->relief = 0.1;
  options.detail->roughness = 0.7;
  options.detail->seed = 1;
  EXPECT_EQ(heights_in(result), rounded(refine(terrain_heights(), make_scheme("gentle"), options)));
}

TEST(server, limit_by_the_shipped_script) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.ply");
  const std::string log = serve("-i " + terrain + " -o " + out + " -m vn -s " +
                                    script_of("Arete: Compute Limit Positions And Normals", folder),
                                folder);
  const Vertices result = read_binary_ply(out);
  ASSERT_EQ(result.rows.size(), 43u * 50u) << log;
  ASSERT_EQ(result.rows[0].size(), 6u);
  // Inside, gentle's limit weights as arete describe prints them, along both axes.
  const Grid<double> heights = terrain_heights();
  const double w[] = {-1.0 / 72, 25.0 / 108, 61.0 / 108, 25.0 / 108, -1.0 / 72};
  for (Index r = 4; r < 38; ++r) {
    for (Index c = 4; c < 45; ++c) {
      double z = 0;
      for (Index i = 0; i < 5; ++i)
        for (Index j = 0; j < 5; ++j) z += w[i] * w[j] * heights(r + i - 2, c + j - 2);
      const auto& row = result.rows[std::size_t(r * 50 + c)];
      EXPECT_NEAR(row[2], z, 1e-3);
      EXPECT_NEAR(row[3] * row[3] + row[4] * row[4] + row[5] * row[5], 1, 1e-5);
      EXPECT_GT(row[5], 0);
    }
  }
}

TEST(server, smoothness_by_the_shipped_script) {
  const test::TemporaryFolder folder;
  const std::string log =
      serve("-i " + terrain + " -s " + script_of("Arete: Smoothness To Log", folder), folder);
  EXPECT_NE(log.find("C^1: certified"), std::string::npos) << log;
  EXPECT_NE(log.find("Hoelder exponent"), std::string::npos) << log;
}

TEST(server, coarsen_by_the_shipped_script) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.ply");
  const std::string script = script_of("Arete: Coarsen Terrain Grid (reverse subdivision)", folder);
  const std::string log = serve("-i " + terrain + " -o " + out + " -s " + script, folder);
  const Vertices result = read_binary_ply(out);
  const auto coarse =
      decompose_grid<double>(terrain_heights().view(), make_scheme("gentle"), {}).coarse;
  EXPECT_EQ(result.faces, std::size_t(2 * (coarse.rows() - 1) * (coarse.cols() - 1))) << log;
  EXPECT_EQ(heights_in(result), rounded(coarse));
}

#ifdef ARETE_MESHLAB_WITH_CGAL
TEST(server, terrain_from_points_by_the_shipped_script) {
  const test::TemporaryFolder folder;
  const std::string cloud = folder.file("cloud.ply");
  {
    std::ofstream ply(cloud);
    ply << "ply\nformat ascii 1.0\nelement vertex 1764\nproperty float x\nproperty float y\n"
           "property float z\nend_header\n";
    for (int i = 0; i < 1764; ++i) {  // two irrational steps spread them; the four corners too
      const double x = i < 4 ? 28000 * (i % 2) : 28000 * std::fmod(0.618034 * i, 1.0);
      const double y = i < 4 ? 21000 * (i / 2) : 21000 * std::fmod(0.754878 * i, 1.0);
      ply << x << ' ' << y << ' ' << 500 + x / 40 - y / 50 << '\n';
    }
  }
  const std::string out = folder.file("out.ply");
  const std::string script = source + "/examples/terrain-from-points.mlx";
  const std::string log = serve("-i " + cloud + " -o " + out + " -s " + script, folder);
  const Vertices result = read_binary_ply(out);
  // 28000 / 720 and 21000 / 720, rounded down, and one.
  ASSERT_EQ(result.rows.size(), 39u * 30u) << log;
  EXPECT_EQ(result.faces, 2u * 38u * 29u);
  for (const auto& row : result.rows)
    EXPECT_NEAR(row[2], 500 + row[0] / 40 - row[1] / 50, 0.01) << log;
}
#endif

TEST(server, the_whole_script_and_quads_in_the_file) {
  const test::TemporaryFolder folder;
  const std::string out = folder.file("out.off");
  const std::string log = serve(
      "-i " + terrain + " -o " + out + " -m mp -s " + source + "/examples/terrain.mlx", folder);
  std::ifstream stream(out);
  std::string word;
  std::size_t vertices = 0, faces = 0;
  stream >> word >> vertices >> faces;
  EXPECT_EQ(vertices, 85u * 99u) << log;
  EXPECT_EQ(faces, 84u * 98u) << "not quads: " << log;
}

TEST(server, a_refusal_writes_no_file_and_says_why) {
  const test::TemporaryFolder folder;
  const std::string in = folder.file("hole.off");
  std::ofstream(in) << "OFF\n8 8 0\n0 0 0\n1 0 0\n2 0 0\n2 1 0\n2 2 0\n1 2 0\n0 2 0\n0 1 0\n"
                       "3 0 1 7\n3 1 2 3\n3 3 4 5\n3 5 6 7\n3 1 3 7\n3 7 3 5\n3 1 3 5\n3 0 2 4\n";
  const std::string out = folder.file("out.ply");
  const std::string log =
      serve("-i " + in + " -o " + out + " -s " + script_of("Arete: Subdivide Terrain Grid", folder),
            folder);
  EXPECT_NE(log.find("not a terrain grid"), std::string::npos) << log;
  EXPECT_EQ(text_of(out), "");
}

}  // namespace
}  // namespace arete::meshlab

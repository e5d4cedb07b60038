// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::run_arete;
using test::run_json;

// The border of Scherk's surface over |x|, |y| <= 0.8, `side` points a side.
void write_scherk(const std::string& path, int side) {
  std::ofstream stream(path);
  stream.precision(17);
  stream << "x,y,z\n";
  for (int k = 0; k < 4 * side; ++k) {
    const double t = -0.8 + 1.6 * (k % side) / side;
    const double x = std::array{t, 0.8, -t, -0.8}[static_cast<std::size_t>(k / side)];
    const double y = std::array{-0.8, t, 0.8, -t}[static_cast<std::size_t>(k / side)];
    stream << x << ',' << y << ',' << std::log(std::cos(y) / std::cos(x)) << '\n';
  }
}

void write_ring(const std::string& path, double radius, double z, double turn, bool backwards) {
  std::ofstream stream(path);
  stream.precision(17);
  for (int k = 0; k < 96; ++k) {
    const double angle = 2 * M_PI * ((backwards ? -k : k) / 96.0 + turn);
    stream << radius * std::cos(angle) << ',' << radius * std::sin(angle) << ',' << z << '\n';
  }
}

TEST(cli_minimal, scherk_s_surface_from_its_border) {
  const test::TemporaryFolder folder;
  write_scherk(folder.file("loop.csv"), 64);
  const auto report = run_json(
      {"minimal", folder.file("loop.csv"), folder.file("out.csv"), "--levels", "3", "--json"});
  EXPECT_NEAR(report.at("area").get<double>(), 3.185307416, 1e-3 * 3.2);
  EXPECT_TRUE(report.at("converged").get<bool>());
  ASSERT_EQ(report.at("levels").size(), 4u);
  for (const auto& level : report.at("levels"))
    EXPECT_LE(level.at("area").get<double>(), level.at("start_area").get<double>());
  std::ifstream stream(folder.file("out.csv"));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "x,y,z");
  int points = 0;
  for (; std::getline(stream, line); ++points) {
    double x = 0, y = 0, z = 0;
    char comma = 0;
    std::istringstream(line) >> x >> comma >> y >> comma >> z;
    EXPECT_NEAR(z, std::log(std::cos(y) / std::cos(x)), 3e-4);
  }
  EXPECT_EQ(points, 33 * 33);
}

TEST(cli_minimal, a_catenoid_between_rings_however_they_are_numbered) {
  const test::TemporaryFolder folder;
  write_ring(folder.file("low.csv"), std::cosh(0.5), -0.5, 0, false);
  write_ring(folder.file("high.csv"), std::cosh(0.5), 0.5, 0.3, true);
  const auto report = run_json({"minimal", folder.file("low.csv"), folder.file("out.csv"), "--ring",
                                folder.file("high.csv"), "--levels", "2", "--smooth", "--json"});
  EXPECT_TRUE(report.at("converged").get<bool>());
  EXPECT_NEAR(report.at("area").get<double>(), M_PI * (1 + std::sinh(1.0)), 0.02);
  // Too far apart: it says so, and is no error.
  write_ring(folder.file("far.csv"), std::cosh(0.5), 4, 0, false);
  const auto run = run_arete({"minimal", folder.file("low.csv"), folder.file("far-out.csv"),
                              "--ring", folder.file("far.csv"), "--levels", "1"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_NE(run.out.find("not a minimal surface yet"), std::string::npos) << run.out;
}

TEST(cli_minimal, writes_meshes_and_pictures) {
  const test::TemporaryFolder folder;
  write_scherk(folder.file("loop.csv"), 8);
  for (const char* name : {"o.vtp", "o.obj", "o.png"}) {
    const auto run =
        run_arete({"minimal", folder.file("loop.csv"), folder.file(name), "--levels", "1"});
    EXPECT_EQ(run.exit_code, 0) << run.err;
    EXPECT_NE(run.out.find("9 x 9: area"), std::string::npos) << run.out;
    EXPECT_GT(std::filesystem::file_size(folder.file(name)), 3000u) << name;
  }
  std::ifstream stream(folder.file("o.obj"));
  std::map<std::string, int> kinds;
  for (std::string line; std::getline(stream, line);) ++kinds[line.substr(0, line.find(' '))];
  EXPECT_EQ(kinds["v"], 81);
  EXPECT_EQ(kinds["vn"], 81);
  EXPECT_EQ(kinds["f"], 128);
}

TEST(cli_minimal, says_what_is_wrong_with_a_boundary) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("flat.csv")) << "0,0\n1,0\n1,1\n0,1\n";
  std::ofstream(folder.file("short.csv")) << "0,0,0\n1,0,0\n1,1,0\n0,0,0\n";
  std::ofstream(folder.file("line.csv")) << "0,0,0\n1,0,0\n2,0,0\n3,0,0\n";
  std::ofstream(folder.file("point.csv")) << "1,1,1\n1,1,1\n1,1,1\n1,1,1\n1,1,2\n";
  const auto complaint = [&](const char* name, int code, test::Arguments more = {}) {
    test::Arguments all{"minimal", folder.file(name), folder.file("o.vtp"), "--levels", "1"};
    all.insert(all.end(), more.begin(), more.end());
    const auto run = run_arete(all);
    EXPECT_EQ(run.exit_code, code) << run.err;
    return run.err;
  };
  EXPECT_NE(complaint("flat.csv", 1).find("2 columns"), std::string::npos);
  EXPECT_NE(complaint("short.csv", 1).find("needs at least 4"), std::string::npos);
  EXPECT_NE(complaint("line.csv", 2).find("no area"), std::string::npos);
  std::ofstream(folder.file("good.csv")) << "0,0,0\n1,0,1\n1,1,0\n0,1,1\n";
  EXPECT_NE(complaint("good.csv", 2, {"--corners", "0,1,1,3"}).find("--corners"),
            std::string::npos);
  EXPECT_NE(complaint("good.csv", 2, {"--levels", "11"}).find("levels"), std::string::npos);
}

}  // namespace
}  // namespace arete

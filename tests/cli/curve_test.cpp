// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::run_arete;
using test::run_json;

std::string text_of(const std::string& path) {
  std::ifstream stream(path);
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(cli_curve, chaikin_cuts_the_corners_of_a_closed_square) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("square.csv")) << "x,y\n0,0\n8,0\n8,8\n0,8\n";
  const auto run = run_arete({"curve", folder.file("square.csv"), folder.file("out.csv"),
                              "--scheme", "chaikin", "--closed"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(text_of(folder.file("out.csv")), "x,y\n2,0\n6,0\n8,2\n8,6\n6,8\n2,8\n0,6\n0,2\n");
}

TEST(cli_curve, tau_says_where_each_point_lies_among_the_control_points) {
  const test::TemporaryFolder folder;
  // On a straight line the parameter is the position itself.
  std::ofstream(folder.file("line.csv")) << "# a line\n0 0\n1 10\n2 20\n3 30\n";
  for (const char* scheme : {"chaikin", "gentle", "ternary-two-step", "three-point"}) {
    ASSERT_EQ(run_arete({"curve", folder.file("line.csv"), folder.file("out.csv"), "--scheme",
                         scheme, "--levels", "2", "--tau", "--overwrite"})
                  .exit_code,
              0);
    std::istringstream lines(text_of(folder.file("out.csv")));
    std::string line;
    int count = 0;
    while (std::getline(lines, line)) {
      double x = 0, y = 0, tau = 0;
      char comma = 0;
      std::istringstream(line) >> x >> comma >> y >> comma >> tau;
      EXPECT_NEAR(x, tau, 1e-12) << scheme;
      EXPECT_NEAR(y, 10 * tau, 1e-12) << scheme;
      ++count;
    }
    EXPECT_GT(count, 10);
  }
}

TEST(cli_curve, the_bundled_contour_becomes_points_a_polyline_and_a_plot) {
  const test::TemporaryFolder folder;
  const std::string contour = std::string(ARETE_SOURCE_DIR) + "/data/poland_contour.csv";
  for (const char* name : {"out.csv", "out.vtp", "out.png"}) {
    const auto report = run_json({"curve", contour, folder.file(name), "--scheme", "four-point",
                                  "--closed", "--levels", "2", "--json"});
    EXPECT_EQ(report.at("points"), 4 * 1309);
    EXPECT_GT(std::filesystem::file_size(folder.file(name)), 10000u) << name;
  }
  // An interpolatory scheme keeps the surveyed points, digit for digit.
  std::istringstream in(text_of(contour)), out(text_of(folder.file("out.csv")));
  std::string wanted, found;
  std::getline(in, wanted);
  std::getline(out, found);
  EXPECT_EQ(found, wanted);
  while (std::getline(in, wanted)) {
    ASSERT_TRUE(std::getline(out, found));
    double a = 0, b = 0, c = 0, d = 0;
    char comma = 0;
    std::istringstream(wanted) >> a >> comma >> b;
    std::istringstream(found) >> c >> comma >> d;
    EXPECT_EQ(a, c);
    EXPECT_EQ(b, d);
    for (int skip = 0; skip < 3; ++skip) std::getline(out, found);
  }
}

}  // namespace
}  // namespace arete

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

#include "run_program.h"
#include "support/source_dir.h"
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
  const std::string contour = arete::test::source_dir() + "/data/poland_contour.csv";
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

// Numbers of a file without header, row by row.
std::vector<std::vector<double>> rows_of(const std::string& path) {
  std::vector<std::vector<double>> rows;
  std::istringstream lines(text_of(path));
  for (std::string line; std::getline(lines, line);) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(std::move(row));
  }
  return rows;
}

TEST(cli_curve, interpolate_passes_through_the_points_by_any_scheme_that_can) {
  const test::TemporaryFolder folder;
  const std::vector<std::array<double, 2>> points{{0, 0}, {1, 3}, {2, -1}, {4, 4}, {7, 2}, {8, 8}};
  {
    std::ofstream stream(folder.file("in.csv"));
    for (const auto& [x, y] : points) stream << x << ',' << y << '\n';
  }
  for (const char* scheme : {"b-spline:degree=3", "b-spline:degree=5", "gentle", "chaikin",
                             "ternary-two-step", "four-point"})
    for (const char* closed : {"--closed", "--json"}) {
      const auto run =
          run_arete({"curve", folder.file("in.csv"), folder.file("out.csv"), "--scheme", scheme,
                     "--levels", "3", "--interpolate", "--limit", "--tau", "--overwrite", closed});
      ASSERT_EQ(run.exit_code, 0) << run.err;
      // Of these only the ternary scheme has no point of the limit at whole parameters.
      std::size_t met = 0;
      for (const auto& row : rows_of(folder.file("out.csv"))) {
        const double whole = std::round(row[2]);
        if (std::abs(row[2] - whole) > 1e-12) continue;
        const auto& [x, y] = points.at(static_cast<std::size_t>(whole) % points.size());
        EXPECT_NEAR(row[0], x, 1e-12) << scheme;
        EXPECT_NEAR(row[1], y, 1e-12) << scheme;
        ++met;
      }
      const std::string name = scheme;
      if (name != "ternary-two-step") {
        EXPECT_EQ(met, points.size()) << scheme << closed;
      }
    }
}

TEST(cli_curve, interpolate_says_why_it_cannot) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("in.csv")) << "0,0\n1,3\n2,-1\n4,4\n";
  const auto refused = [&](const std::string& scheme, const std::string& boundary) {
    const auto run = run_arete({"curve", folder.file("in.csv"), folder.file("out.csv"), "--scheme",
                                scheme, "--interpolate", "--boundary", boundary});
    EXPECT_EQ(run.exit_code, 2);
    return run.err;
  };
  EXPECT_NE(refused("mask:arity=2,first=0,coefficients=1/2;1/2;1/2;1/2", "clamp")
                .find("alternate with a period of 2.00 samples have limit 0"),
            std::string::npos);
  EXPECT_NE(refused("chaikin", "none").find("fewer limit values than control points"),
            std::string::npos);
  EXPECT_NE(refused("four-point:omega=1/2", "clamp").find("no certified limit"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_curve, tangents_and_curvature_are_those_of_the_limit) {
  const test::TemporaryFolder folder;
  // A circle of radius 2 by 64 control points: the cubic spline's limit is nearly a circle.
  {
    std::ofstream stream(folder.file("circle.csv"));
    stream << "x,y\n";
    for (int i = 0; i < 64; ++i)
      stream << 2 * std::cos(i * M_PI / 32) << ',' << 2 * std::sin(i * M_PI / 32) << '\n';
  }
  ASSERT_EQ(run_arete({"curve", folder.file("circle.csv"), folder.file("out.csv"), "--scheme",
                       "b-spline", "--closed", "--interpolate", "--tangents", "--curvature",
                       "--tau", "--levels", "2"})
                .exit_code,
            0);
  const std::string text = text_of(folder.file("out.csv"));
  EXPECT_EQ(text.substr(0, text.find('\n')), "x,y,tau,dx,dy,curvature");
  std::ofstream(folder.file("bare.csv")) << text.substr(text.find('\n') + 1);
  const auto rows = rows_of(folder.file("bare.csv"));
  ASSERT_EQ(rows.size(), 256u);
  for (const auto& row : rows) {
    const double angle = row[2] * M_PI / 32;
    EXPECT_NEAR(row[0], 2 * std::cos(angle), 1e-5);
    EXPECT_NEAR(row[3], -2 * std::sin(angle) * M_PI / 32, 1e-5);
    EXPECT_NEAR(row[4], 2 * std::cos(angle) * M_PI / 32, 1e-5);
    EXPECT_NEAR(row[5], 0.5, 1e-3);  // left turns are positive
  }
  // Chaikin's curve has tangents, but no curvature everywhere.
  const auto run = run_arete({"curve", folder.file("circle.csv"), folder.file("no.csv"), "--scheme",
                              "chaikin", "--closed", "--curvature"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("--curvature: the limit of chaikin is not certified to be C^2"),
            std::string::npos)
      << run.err;
}

TEST(cli_curve, fixed_ends_begin_and_end_at_the_control_points) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("in.csv")) << "0,0\n1,3\n2,-1\n4,4\n";
  for (const char* scheme : {"chaikin", "b-spline", "gentle", "three-point"}) {
    ASSERT_EQ(
        run_arete({"curve", folder.file("in.csv"), folder.file("out.csv"), "--scheme", scheme,
                   "--levels", "2", "--fixed-ends", "--tau", "--boundary", "clamp", "--overwrite"})
            .exit_code,
        0);
    const auto rows = rows_of(folder.file("out.csv"));
    EXPECT_EQ(rows.front(), (std::vector<double>{0, 0, 0})) << scheme;
    EXPECT_EQ(rows.back(), (std::vector<double>{4, 4, 3})) << scheme;
    for (std::size_t i = 1; i < rows.size(); ++i) EXPECT_GT(rows[i][2], rows[i - 1][2]) << scheme;
  }
  const auto run = run_arete({"curve", folder.file("in.csv"), folder.file("no.csv"), "--scheme",
                              "chaikin", "--closed", "--fixed-ends"});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_NE(run.err.find("a closed curve has no ends"), std::string::npos) << run.err;
}

// Without ghosts the wider stencil of the derivative reaches fewer points: all columns agree on
// them.
TEST(cli_curve, derivatives_without_ghosts_belong_to_their_points) {
  const test::TemporaryFolder folder;
  {
    std::ofstream stream(folder.file("parabola.csv"));
    for (int i = 0; i < 12; ++i) stream << i << ',' << i * i << '\n';
  }
  ASSERT_EQ(run_arete({"curve", folder.file("parabola.csv"), folder.file("out.csv"), "--scheme",
                       "dubuc-deslauriers:points=6", "--levels", "2", "--boundary", "none",
                       "--tangents", "--curvature"})
                .exit_code,
            0);
  const auto rows = rows_of(folder.file("out.csv"));
  ASSERT_GT(rows.size(), 5u);
  for (const auto& row : rows) {
    EXPECT_NEAR(row[1], row[0] * row[0], 1e-10);
    EXPECT_NEAR(row[2], 1, 1e-10);
    EXPECT_NEAR(row[3], 2 * row[0], 1e-10);
    EXPECT_NEAR(row[4], 2 / std::pow(1 + 4 * row[0] * row[0], 1.5), 1e-10);
  }
}

}  // namespace
}  // namespace arete

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "run_program.h"
#include "support/oracle.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using nlohmann::json;
using test::run_arete;
using test::run_json;

std::vector<double> first_column(const std::string& path) {
  std::vector<double> values;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) values.push_back(std::stod(line));
  return values;
}

TEST(cli_spline, records) {
  const test::TemporaryFolder folder;
  for (const json& record : test::ternary_and_reverse_records("r.spline")) {
    const auto& v = record.at("input").at("v");
    {
      std::ofstream stream(folder.file("in.csv"));
      for (const auto& value : v) stream << value << '\n';
    }
    const auto report = run_json({"spline", folder.file("in.csv"), folder.file("out.csv"),
                                  "--levels", "1", "--json", "--overwrite"});
    EXPECT_NEAR(report.at("bending_energy").get<double>(),
                to_double(test::exact(record.at("expect").at("bending_energy"))), 1e-10);
    const auto points = first_column(folder.file("out.csv"));
    ASSERT_EQ(points.size(), 2 * v.size() - 1);
    for (std::size_t i = 0; i < v.size(); ++i)
      EXPECT_NEAR(points[2 * i], v[i].get<double>(), 1e-12) << record.at("id");
    EXPECT_NEAR(points[1], to_double(test::exact(record.at("expect").at("values").at("1/2"))),
                1e-12);

    ASSERT_EQ(run_arete({"spline", folder.file("in.csv"), folder.file("polygon.csv"), "--levels",
                         "1", "--polygon", "--overwrite"})
                  .exit_code,
              0);
    const auto polygon = first_column(folder.file("polygon.csv"));
    const auto expected = test::exact_list(record.at("expect").at("control_after_one_refinement"));
    ASSERT_EQ(polygon.size(), expected.size());
    for (std::size_t i = 0; i < polygon.size(); ++i)
      EXPECT_NEAR(polygon[i], to_double(expected[i]), 1e-12);
  }
}

// Two doors to one curve: the solved spline, and the cubic B-spline in cardinal mode.
TEST(cli_spline, equals_the_cardinal_cubic_spline) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("in.csv")) << "x,y\n0,0\n1,3\n2,-1\n4,4\n7,2\n8,8\n";
  for (const char* closed : {"--tau", "--closed"}) {
    ASSERT_EQ(run_arete({"spline", folder.file("in.csv"), folder.file("a.csv"), "--levels", "3",
                         "--overwrite", "--tangents", "--curvature", closed})
                  .exit_code,
              0);
    ASSERT_EQ(run_arete({"curve", folder.file("in.csv"), folder.file("b.csv"), "--levels", "3",
                         "--overwrite", "--scheme", "b-spline", "--interpolate", "--limit",
                         "--tangents", "--curvature", closed})
                  .exit_code,
              0);
    std::ifstream a(folder.file("a.csv")), b(folder.file("b.csv"));
    std::string line_a, line_b;
    int lines = 0;
    for (; std::getline(a, line_a) && std::getline(b, line_b); ++lines) {
      if (lines == 0) {
        EXPECT_EQ(line_a, line_b);
        continue;
      }
      std::istringstream cells_a(line_a), cells_b(line_b);
      for (std::string x, y; std::getline(cells_a, x, ',') && std::getline(cells_b, y, ',');)
        EXPECT_NEAR(std::stod(x), std::stod(y), 1e-9 * std::max(1.0, std::abs(std::stod(y))));
    }
    EXPECT_EQ(lines, std::string(closed) == "--closed" ? 49 : 42);
    EXPECT_FALSE(std::getline(b, line_b));
  }
}

TEST(cli_spline, draws_and_refuses) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("in.csv")) << "0,1\n1,3\n2,3\n3,4\n4,2\n";
  for (const char* name : {"o.png", "o.vtp"}) {
    EXPECT_EQ(run_arete({"spline", folder.file("in.csv"), folder.file(name)}).exit_code, 0);
    EXPECT_GT(std::filesystem::file_size(folder.file(name)), 1000u);
  }
  const auto refuse = [&](test::Arguments more) {
    test::Arguments all{"spline", folder.file("in.csv"), folder.file("no.csv")};
    all.insert(all.end(), more.begin(), more.end());
    const auto run = run_arete(all);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    return run.err;
  };
  EXPECT_NE(refuse({"--levels", "-1"}).find("--levels"), std::string::npos);
  EXPECT_NE(refuse({"--levels", "40"}).find("2^30"), std::string::npos);
  EXPECT_NE(refuse({"--polygon", "--tangents"}).find("--polygon"), std::string::npos);
}

}  // namespace
}  // namespace arete

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
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

std::vector<std::vector<double>> rows_of(const std::string& path) {
  std::vector<std::vector<double>> rows;
  std::ifstream stream(path);
  for (std::string line; std::getline(stream, line);) {
    std::vector<double> row;
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) row.push_back(std::stod(cell));
    rows.push_back(std::move(row));
  }
  return rows;
}

void write_points(const std::string& path, const json& points) {
  std::ofstream stream(path);
  for (const auto& point : points) {
    for (std::size_t c = 0; c < point.size(); ++c)
      stream << (c == 0 ? "" : ",") << to_double(test::exact(point[c]));
    stream << '\n';
  }
}

void expect_points(const std::string& path, const json& expected, const std::string& id) {
  const auto rows = rows_of(path);
  ASSERT_EQ(rows.size(), expected.size()) << id;
  for (std::size_t r = 0; r < rows.size(); ++r)
    for (std::size_t c = 0; c < 2; ++c)
      EXPECT_NEAR(rows[r].at(c), to_double(test::exact(expected[r][c])), 1e-12) << id;
}

TEST(cli_ifs, attractors_of_the_records) {
  const test::TemporaryFolder folder;
  for (const json& record : test::ternary_and_reverse_records("r.attractor")) {
    const json& input = record.at("input");
    write_points(folder.file("p.csv"), input.at("control"));
    const std::string system = input.at("scheme") == "de_rham" ? "de-rham" : "bezier";
    const auto run = run_json(
        {"ifs", system, folder.file("out.csv"), "--control", folder.file("p.csv"), "--depth",
         std::to_string(input.at("depth").get<int>()), "--overwrite", "--json"});
    EXPECT_EQ(run.at("points"), record.at("expect").at("points").size());
    expect_points(folder.file("out.csv"), record.at("expect").at("points"), record.at("id"));
  }
}

TEST(cli_ifs, a_contour_gives_n_2n_4n_points_on_one_curve) {
  const test::TemporaryFolder folder;
  for (const json& record : test::ternary_and_reverse_records("r.contour_ifs")) {
    write_points(folder.file("p.csv"), record.at("input").at("closed_polygon"));
    for (int depth = 0; depth <= 2; ++depth) {
      const auto run =
          run_json({"ifs", "contour", folder.file("out.csv"), "--control", folder.file("p.csv"),
                    "--depth", std::to_string(depth), "--overwrite", "--json"});
      expect_points(folder.file("out.csv"),
                    record.at("expect").at("points_" + std::to_string(depth)), record.at("id"));
      // The maps of every arc, null where it is collinear.
      const json& maps = record.at("expect").at("M_L");
      ASSERT_EQ(run.at("goldman_maps").size(), maps.size());
      for (std::size_t i = 0; i < maps.size(); ++i) {
        ASSERT_EQ(run.at("goldman_maps")[i].is_null(), maps[i].is_null());
        if (maps[i].is_null()) continue;
        for (std::size_t r = 0; r < 3; ++r)
          for (std::size_t c = 0; c < 3; ++c)
            EXPECT_NEAR(run.at("goldman_maps")[i][0][r][c].get<double>(),
                        to_double(test::exact(maps[i][r][c])), 1e-12);
      }
    }
  }
}

// The same curve by two doors.
TEST(cli_ifs, of_a_scheme_is_the_refined_polygon) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("p.csv")) << "0,0\n1,3\n2,-1\n4,4\n7,2\n8,8\n";
  ASSERT_EQ(run_arete({"ifs", "chaikin", folder.file("ifs.csv"), "--control", folder.file("p.csv"),
                       "--depth", "3", "--closed"})
                .exit_code,
            0);
  ASSERT_EQ(run_arete({"curve", folder.file("p.csv"), folder.file("curve.csv"), "--scheme",
                       "chaikin", "--levels", "3", "--closed"})
                .exit_code,
            0);
  EXPECT_EQ(rows_of(folder.file("ifs.csv")), rows_of(folder.file("curve.csv")));
  // And on the limit.
  ASSERT_EQ(run_arete({"ifs", "b-spline", folder.file("ifs.csv"), "--control", folder.file("p.csv"),
                       "--depth", "3", "--closed", "--on-curve", "--overwrite"})
                .exit_code,
            0);
  ASSERT_EQ(run_arete({"curve", folder.file("p.csv"), folder.file("curve.csv"), "--scheme",
                       "b-spline", "--levels", "3", "--closed", "--limit", "--overwrite"})
                .exit_code,
            0);
  auto limit = rows_of(folder.file("curve.csv"));
  // Arc k of the sliding windows begins one control point later.
  std::rotate(limit.begin(), limit.begin() + 8, limit.end());
  const auto arcs = rows_of(folder.file("ifs.csv"));
  ASSERT_EQ(arcs.size(), limit.size());
  for (std::size_t i = 0; i < arcs.size(); ++i)
    for (std::size_t c = 0; c < 2; ++c) EXPECT_NEAR(arcs[i][c], limit[i][c], 1e-12);
}

TEST(cli_ifs, the_chaos_game_is_reproducible_and_on_the_curve) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("p.csv")) << "0,0\n1,3\n3,3\n4,0\n";
  const auto play = [&](const char* name, const char* seed) {
    const auto run = run_json({"ifs", "bezier", folder.file(name), "--control",
                               folder.file("p.csv"), "--chaos", "500", "--seed", seed, "--json"});
    EXPECT_EQ(run.at("points"), 500);
    return rows_of(folder.file(name));
  };
  const auto one = play("one.csv", "3");
  EXPECT_EQ(one, play("same.csv", "3"));
  EXPECT_NE(one, play("other.csv", "4"));
  for (const auto& point : one) {
    // x(t) = 3t + 3t^2 - 2t^3 of this polygon is increasing: find t, then compare y.
    double low = 0, high = 1;
    for (int i = 0; i < 60; ++i) {
      const double t = (low + high) / 2;
      (3 * t + 3 * t * t - 2 * t * t * t < point[0] ? low : high) = t;
    }
    EXPECT_NEAR(point[1], 9 * low * (1 - low), 1e-9);
  }
}

TEST(cli_ifs, pictures_and_lines) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("p.csv")) << "0,0\n1,3\n3,3\n4,0\n";
  const test::Arguments begin{"ifs", "perturbed-bezier"};
  const auto with = [&](const char* name, test::Arguments more) {
    test::Arguments all = begin;
    all.push_back(folder.file(name));
    all.insert(all.end(), {"--control", folder.file("p.csv")});
    all.insert(all.end(), more.begin(), more.end());
    return run_arete(all);
  };
  EXPECT_EQ(with("a.png", {}).exit_code, 0);
  EXPECT_EQ(with("a.vtp", {}).exit_code, 0);
  EXPECT_EQ(with("b.png", {"--chaos", "20000"}).exit_code, 0);
  for (const char* name : {"a.png", "a.vtp", "b.png"})
    EXPECT_GT(std::filesystem::file_size(folder.file(name)), 1000u) << name;
  EXPECT_EQ(with("b.vtp", {"--chaos", "10"}).exit_code, 2);
}

TEST(cli_ifs, says_what_does_not_fit) {
  const test::TemporaryFolder folder;
  std::ofstream(folder.file("p.csv")) << "0,0\n1,3\n3,3\n4,0\n5,5\n";
  const auto complaint = [&](const std::string& system, test::Arguments more) {
    test::Arguments all{"ifs", system, folder.file("o.csv"), "--control", folder.file("p.csv")};
    all.insert(all.end(), more.begin(), more.end());
    const auto run = run_arete(all);
    EXPECT_EQ(run.exit_code, 2) << run.err;
    return run.err;
  };
  EXPECT_NE(complaint("perturbed-bezier", {}).find("takes 4 + k 3 control points, not 5"),
            std::string::npos);
  EXPECT_NE(complaint("bezier:degree=9", {}).find("takes 10 + k 9"), std::string::npos);
  EXPECT_NE(complaint("natural-spline", {"--closed"}).find("cannot be closed"), std::string::npos);
  EXPECT_NE(complaint("nonsense", {}).find("nonsense"), std::string::npos);
  EXPECT_NE(complaint("bezier", {"--depth", "41"}).find("more than 2^40"), std::string::npos);
  EXPECT_EQ(folder.entries(), 1);
}

}  // namespace
}  // namespace arete

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

TEST(cli_analyze, prints_the_keys_of_the_contract_with_proved_values) {
  const auto a = run_json({"analyze", "gentle", "--json"});
  EXPECT_EQ(a.at("smoothness").at("certified"), 1);
  EXPECT_EQ(a.at("smoothness").at("power"), 2);
  EXPECT_EQ(a.at("smoothness").at("norm"), "95/128");
  EXPECT_EQ(a.at("refuted_at"), 2);
  EXPECT_EQ(a.at("stable"), true);
  // log2(16/5)
  EXPECT_NEAR(a.at("hoelder").at("lower"), 1.6780719051126376, 1e-9);
  EXPECT_NEAR(a.at("hoelder").at("upper"), 1.6780719051126376, 1e-9);
  EXPECT_EQ(a.at("theorems").size(), 3u);
  for (const auto& theorem : a.at("theorems"))
    for (const char* key : {"name", "holds", "value"}) EXPECT_TRUE(theorem.contains(key));
  EXPECT_TRUE(a.contains("mask"));
}

TEST(cli_analyze, an_exponent_that_is_not_attained_is_called_so) {
  const auto a = run_json({"analyze", "four-point", "--json"});
  EXPECT_EQ(a.at("smoothness").at("certified"), 1);
  EXPECT_EQ(a.at("refuted_at"), 2);
  EXPECT_EQ(a.at("hoelder").at("lower"), 2);
  EXPECT_EQ(a.at("hoelder").at("attained"), false);
}

TEST(cli_analyze, the_counterexample_to_theorem_4_is_exposed) {
  const auto a = run_json({"analyze", "three-parameter:a=1/4,c=-19/20", "--json"});
  ASSERT_EQ(a.at("theorems").size(), 1u);
  EXPECT_EQ(a.at("theorems").at(0).at("holds"), true);
  EXPECT_EQ(a.at("theorems").at(0).at("sound"), false);
  EXPECT_EQ(a.at("refuted_at"), 1);
  EXPECT_EQ(a.at("hoelder").at("word"), "01");
}

TEST(cli_analyze, the_basic_limit_function_is_drawn) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(run_arete({"analyze", "ternary-two-step", "--plot", folder.file("phi.png")}).exit_code,
            0);
  EXPECT_GT(std::filesystem::file_size(folder.file("phi.png")), 5000u);
  EXPECT_EQ(folder.entries(), 1);
}

TEST(cli_map, cells_are_what_analyze_says_of_their_schemes) {
  const test::TemporaryFolder folder;
  const auto run = run_arete({"map", "four-parameter", folder.file("map.csv"), "--x",
                              "lambda,mu=0:1/4:3", "--y", "omega=-1/32:1/16:4"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::ifstream stream(folder.file("map.csv"));
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "x,omega,valid,certified,refuted_next,stable,hoelder_lower");
  int rows = 0;
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    std::string lambda, omega, valid, certified;
    std::getline(cells, lambda, ',');
    std::getline(cells, omega, ',');
    std::getline(cells, valid, ',');
    std::getline(cells, certified, ',');
    const auto a = run_json(
        {"analyze", "four-parameter:lambda=" + lambda + ",mu=" + lambda + ",omega=" + omega,
         "--json"});
    EXPECT_EQ(valid, "1");
    EXPECT_EQ(std::stoi(certified), a.at("smoothness").at("certified")) << line;
    ++rows;
  }
  EXPECT_EQ(rows, 12);
}

TEST(cli_map, bad_ranges_are_misuse) {
  const test::TemporaryFolder folder;
  for (const char* x : {"omega", "omega=0:1", "omega=0:1:0", "omega=a:1:5", "=0:1:5", "w=0:1:5"}) {
    const auto run =
        run_arete({"map", "four-parameter", folder.file("m.csv"), "--x", x, "--y", "nu=0:1:3"});
    EXPECT_EQ(run.exit_code, 2) << x << run.err;
  }
  EXPECT_EQ(folder.entries(), 0);
}

TEST(cli_map, a_picture_is_drawn) {
  const test::TemporaryFolder folder;
  EXPECT_EQ(run_arete({"map", "four-parameter-c2", folder.file("map.png"), "--x", "nu=0:1:9", "--y",
                       "omega=-1/8:1/4:9", "--size", "500x400"})
                .exit_code,
            0);
  EXPECT_GT(std::filesystem::file_size(folder.file("map.png")), 2000u);
}

}  // namespace
}  // namespace arete

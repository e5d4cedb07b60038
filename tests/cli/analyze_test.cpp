// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
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
  // (1+z)^2 divides the symbol: the masks of the first and of the second differences.
  ASSERT_EQ(a.at("orders").size(), 3u);
  EXPECT_EQ(a.at("orders").at(1).at("difference_mask"),
            (nlohmann::json{"-3/64", "5/16", "-1/32", "5/16", "-3/64"}));
  EXPECT_EQ(a.at("orders").at(1).at("norm"), "95/128");
  EXPECT_TRUE(a.at("orders").at(2).at("difference_mask").is_null());
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
  ASSERT_GE(a.at("theorems").size(), 1u);
  EXPECT_EQ(a.at("theorems").at(0).at("name"), "theorem 4 (Shen, Huang)");
  EXPECT_EQ(a.at("theorems").at(0).at("holds"), true);
  EXPECT_EQ(a.at("theorems").at(0).at("sound"), false);
  EXPECT_EQ(a.at("refuted_at"), 1);
  EXPECT_EQ(a.at("hoelder").at("word"), "01");
}

// (D1 + D2)/2 diverges although D1 and D2, both found by the program, converge.
TEST(cli_analyze, the_counterexample_to_property_1_is_exposed_with_its_two_parts) {
  const auto a = run_json({"analyze", "three-parameter:a=6/25,c=-24/25,m=3", "--json"});
  const auto& theorems = a.at("theorems");
  const auto property = std::find_if(theorems.begin(), theorems.end(), [](const auto& theorem) {
    return theorem.at("name") == "property 1 (Shen, Huang)";
  });
  ASSERT_NE(property, theorems.end());
  EXPECT_EQ(property->at("holds"), true);
  EXPECT_EQ(property->at("sound"), false);
  EXPECT_NE(property->at("verdict").get<std::string>().find("CONTRADICTED"), std::string::npos);
  // Where the scheme converges it is no counterexample.
  const auto converging = run_json({"analyze", "three-parameter", "--json"});
  for (const auto& theorem : converging.at("theorems"))
    EXPECT_NE(theorem.at("name"), "property 1 (Shen, Huang)");
}

TEST(cli_analyze, refutations_show_the_polynomial_that_proves_them) {
  // AB of (a, b, c) = (1/4, 19/20, -19/20)/2: trace (ab+bc+ca)/4, determinant ab^2c/16.
  const auto run = run_arete({"analyze", "three-parameter:a=1/4,c=-19/20"});
  EXPECT_NE(run.out.find("word 01"), std::string::npos) << run.out;
  EXPECT_NE(run.out.find("characteristic polynomial x^2 + 361/1600 x - 6859/512000"),
            std::string::npos)
      << run.out;
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

// A panel more for every certified derivative.
TEST(cli_analyze, plots_grow_with_the_certified_order) {
  const test::TemporaryFolder folder;
  std::vector<int> heights;
  for (const char* scheme : {"craggy", "gentle", "b-spline", "b-spline:degree=32"}) {
    const std::string png = folder.file(std::to_string(heights.size()) + ".png");
    EXPECT_EQ(run_arete({"analyze", scheme, "--plot", png}).exit_code, 0) << scheme;
    std::ifstream stream(png, std::ios::binary);
    stream.seekg(20);  // width and height follow the header's name, big-endian
    unsigned char bytes[4] = {};
    stream.read(reinterpret_cast<char*>(bytes), 4);
    heights.push_back(bytes[2] * 256 + bytes[3]);
  }
  EXPECT_LT(heights[0], heights[1]);
  EXPECT_LT(heights[1], heights[2]);
  EXPECT_LT(heights[2], heights[3]);
  EXPECT_EQ(run_arete({"analyze", "gentle", "--plot", folder.file("phi.svg")}).exit_code, 2);
}

TEST(cli_map, one_parameter_is_enough) {
  const test::TemporaryFolder folder;
  const auto run =
      run_arete({"map", "four-point", folder.file("line.csv"), "--x", "omega=0:1/4:5"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  std::ifstream stream(folder.file("line.csv"));
  std::string header, line;
  std::getline(stream, header);
  EXPECT_EQ(header, "omega,valid,certified,refuted_next,stable,hoelder_lower");
  std::vector<std::string> lines;
  while (std::getline(stream, line)) lines.push_back(line);
  ASSERT_EQ(lines.size(), 5u);
  EXPECT_TRUE(lines[0].starts_with("0,1,0,1,1,")) << lines[0];
  EXPECT_TRUE(lines[1].starts_with("0.0625,1,1,1,1,2")) << lines[1];
  EXPECT_EQ(
      run_arete({"map", "four-point", folder.file("line.png"), "--x", "omega=0:1/4:21"}).exit_code,
      0);
}

TEST(cli_map, printed_regions_are_named_with_where_they_hold) {
  const test::TemporaryFolder folder;
  const auto four = run_arete({"map", "four-parameter", folder.file("four.png"), "--x",
                               "lambda,mu=0:1/4:7", "--y", "omega=-1/16:1/8:7"});
  ASSERT_EQ(four.exit_code, 0) << four.err;
  EXPECT_NE(four.out.find("theorem 1 (Zhao, Peng, Ye), C^0 holds"), std::string::npos) << four.out;
  EXPECT_NE(four.out.find("theorem 2 (Zhao, Peng, Ye), C^1 holds inside its outline"),
            std::string::npos)
      << four.out;
  // lambda = 1/8 - 2 omega is a line of this plane.
  EXPECT_NE(four.out.find("theorem 3 (Zhao, Peng, Ye), C^2 holds on its line"), std::string::npos)
      << four.out;
  const auto off = run_arete({"map", "four-parameter:mu=1/5,omega=1/32", folder.file("off.png"),
                              "--x", "lambda=0:1/4:5", "--y", "nu=0:1:5"});
  EXPECT_NE(off.out.find("theorem 3 (Zhao, Peng, Ye), C^2 holds at single points"),
            std::string::npos)
      << off.out;
  const auto hoelder = run_arete({"map", "corner-cutting", folder.file("h.png"), "--x", "u=0:1:9",
                                  "--y", "v=0:1:9", "--show", "hoelder", "--no-outlines"});
  EXPECT_EQ(hoelder.exit_code, 0) << hoelder.err;
  EXPECT_EQ(hoelder.out.find("holds"), std::string::npos) << hoelder.out;
}

// Over one parameter the exponents are as sharp as those of `arete analyze`, and drawn as a graph.
TEST(cli_map, exponents_along_a_line_are_those_of_analyze) {
  const test::TemporaryFolder folder;
  const std::string table = folder.file("line.csv");
  ASSERT_EQ(
      run_arete({"map", "ternary-two-step", table, "--x", "b=-1/5:1/10:2", "--show", "hoelder"})
          .exit_code,
      0);
  std::ifstream stream(table);
  std::string header, first, last;
  std::getline(stream, header);
  std::getline(stream, first);
  std::getline(stream, last);
  // The published exponents at b = -1/5 and 1/10, see docs/errata.md.
  EXPECT_NEAR(std::stod(first.substr(first.rfind(',') + 1)), 2.090713515, 1e-8);
  EXPECT_NEAR(std::stod(last.substr(last.rfind(',') + 1)), 2.327733685, 1e-8);
  const std::string graph = folder.file("line.png");
  ASSERT_EQ(run_arete({"map", "ternary-two-step", graph, "--x", "b=-1/5:1/10:4", "--show",
                       "hoelder", "--size", "500x300"})
                .exit_code,
            0);
  EXPECT_GT(std::filesystem::file_size(graph), 2000u);
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

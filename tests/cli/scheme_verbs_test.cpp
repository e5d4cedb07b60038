// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>
#include <set>

#include "run_program.h"
#include "support/schemes.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::run_arete;
using test::run_json;

TEST(cli, schemes_lists_the_whole_catalogue_with_ranges_and_defaults) {
  const auto object = run_json({"schemes", "--json"});
  ASSERT_EQ(object.at("schemes").size(), catalogue().size());
  for (std::size_t i = 0; i < catalogue().size(); ++i) {
    const auto& row = object.at("schemes").at(i);
    EXPECT_EQ(row.at("name"), catalogue()[i].name);
    ASSERT_EQ(row.at("parameters").size(), catalogue()[i].parameters.size());
    for (const auto& parameter : row.at("parameters"))
      for (const char* key : {"name", "kind", "range", "usual", "default", "meaning"})
        EXPECT_TRUE(parameter.contains(key)) << key;
  }
  const std::string text = run_arete({"schemes"}).out;
  for (const Family& family : catalogue())
    EXPECT_NE(("\n" + text).find("\n" + family.name + "\n"), std::string::npos) << family.name;
}

TEST(cli, describe_prints_the_keys_of_the_contract_exactly) {
  const auto d = run_json({"describe", "b-spline:degree=3", "--json"});
  const std::set<std::string> contract{"scheme",
                                       "arity",
                                       "first",
                                       "mask",
                                       "tau",
                                       "sum_rules",
                                       "reproduction_degree",
                                       "interpolatory",
                                       "overshoot",
                                       "limit_stencil",
                                       "derivative_stencil"};
  for (const std::string& key : contract) EXPECT_TRUE(d.contains(key)) << key;
  EXPECT_EQ(d.at("overshoot"), "0");
  EXPECT_EQ(d.at("mask"), (nlohmann::json{"1/8", "1/2", "3/4", "1/2", "1/8"}));
  EXPECT_EQ(d.at("first"), -2);
  EXPECT_EQ(d.at("tau"), "0");
  EXPECT_EQ(d.at("sum_rules"), 4);
  EXPECT_EQ(d.at("interpolatory"), false);
  EXPECT_EQ(d.at("limit_stencil"), (nlohmann::json{{"-1", "1/6"}, {"0", "2/3"}, {"1", "1/6"}}));
  EXPECT_EQ(d.at("derivative_stencil"), (nlohmann::json{{"-1", "-1/2"}, {"1", "1/2"}}));
  EXPECT_TRUE(run_json({"describe", "craggy", "--json"}).at("derivative_stencil").is_null());
}

// The bound is of the limit, not of one level, and of both when a surface is made.
TEST(cli, describe_bounds_how_far_limits_leave_the_range_of_the_data) {
  const auto d = run_json({"describe", "four-point", "--json"});
  const double limit = to_double(parse_rational(d.at("overshoot").get<std::string>()));
  EXPECT_EQ(d.at("overshoot_of_level"), "1/8");
  // Lambda of the 4-point scheme is 1.25 at one level, hardly more in the limit.
  EXPECT_GE(limit, 0.125);
  EXPECT_LT(limit, 0.127);
  const double surface = to_double(parse_rational(d.at("overshoot_of_surface").get<std::string>()));
  EXPECT_NEAR(surface, ((1 + 2 * limit) * (1 + 2 * limit) - 1) / 2, 1e-8);
  EXPECT_TRUE(run_json({"describe", "four-point:omega=1/2", "--json"}).at("overshoot").is_null());
  EXPECT_NE(run_arete({"describe", "four-point"}).out.find("for limits"), std::string::npos);
}

TEST(cli, describe_round_trips_through_json_for_every_family) {
  const test::TemporaryFolder folder;
  for (const Scheme& scheme : test::sample_schemes()) {
    const auto first = run_json({"describe", scheme.text(), "--json"});
    std::ofstream(folder.file("s.json")) << first.dump();
    EXPECT_EQ(run_json({"describe", "@" + folder.file("s.json"), "--json"}), first);
    EXPECT_EQ(parse_scheme(first.at("scheme").get<std::string>()), scheme);
  }
}

TEST(cli, every_verb_explains_itself) {
  for (const char* verb : {"schemes", "describe", "curve", "refine", "render"}) {
    const auto run = run_arete({verb, "--help"});
    EXPECT_EQ(run.exit_code, 0);
    EXPECT_NE(run.out.find("Usage: arete " + std::string(verb)), std::string::npos);
  }
  EXPECT_EQ(run_arete({"--version"}).out.rfind("arete ", 0), 0u);
}

}  // namespace
}  // namespace arete

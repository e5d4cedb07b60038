// SPDX-License-Identifier: GPL-3.0-or-later
// The names of the dialogs are what users' scripts are made of.
#include "arete/meshlab/filter_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <set>

#include "arete/meshlab/scheme_fields.h"
#include "arete/scheme/catalogue.h"
#include "meshlab/grid_mesh.h"

namespace arete::meshlab {
namespace {

std::vector<std::string> field_names(const Filter& filter) {
  std::vector<std::string> names;
  for (const Field& field : filter.fields({})) names.push_back(field.name);
  return names;
}

TEST(filter_table, names_are_a_script_api) {
  const std::vector<std::string> scheme{"Scheme", "Lambda", "Mu", "Nu", "Omega", "SchemeText"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), scheme.begin(), scheme.end());
    return more;
  };
  const auto& table = filter_table();
#ifdef ARETE_MESHLAB_WITH_CGAL
  ASSERT_EQ(table.size(), 5u);
  EXPECT_EQ(table[4].name, "Arete: Terrain From Points");
  EXPECT_EQ(field_names(table[4]), (std::vector<std::string>{"Spacing", "Method", "Outside",
                                                             "DropOutliers", "KeepQuads"}));
#else
  ASSERT_EQ(table.size(), 4u);
#endif
  EXPECT_EQ(table[0].name, "Arete: Subdivide Terrain Grid");
  EXPECT_EQ(field_names(table[0]), with({"Levels", "Boundary", "Coordinates", "DetailAmount",
                                         "DetailRoughness", "Seed", "KeepQuads"}));
  EXPECT_EQ(table[1].name, "Arete: Compute Limit Positions And Normals");
  EXPECT_EQ(field_names(table[1]), with({"Boundary", "Coordinates"}));
  EXPECT_EQ(table[2].name, "Arete: Smoothness To Log");
  EXPECT_EQ(field_names(table[2]), with({"MaxPower"}));
  EXPECT_EQ(table[3].name, "Arete: Coarsen Terrain Grid (reverse subdivision)");
  EXPECT_EQ(field_names(table[3]),
            with({"Levels", "Boundary", "Coordinates", "Mode", "KeepQuads", "DetailsToQuality"}));
}

TEST(filter_table, choices_are_known_to_scripts_by_number) {
  const std::vector<std::string> schemes{"gentle",
                                         "craggy",
                                         "four-point",
                                         "four-parameter",
                                         "four-parameter-c2",
                                         "b-spline",
                                         "dubuc-deslauriers",
                                         "chaikin",
                                         "de-rham",
                                         "corner-cutting",
                                         "two-parameter",
                                         "three-parameter",
                                         "three-point",
                                         "ternary-two-step",
                                         "ternary-two-step-9",
                                         "ternary-four-point"};
  ASSERT_GE(offered_families().size(), schemes.size());
  EXPECT_TRUE(std::equal(schemes.begin(), schemes.end(), offered_families().begin()));
  for (const Field& field : filter_table()[0].fields({})) {
    if (field.name == "Boundary") {
      EXPECT_EQ(field.choices,
                (std::vector<std::string>{"extrapolate", "clamp", "reflect", "periodic", "none"}));
    }
  }
}

TEST(filter_table, every_family_with_defaults_is_offered) {
  std::set<std::string> offered(offered_families().begin(), offered_families().end());
  for (const Family& family : catalogue()) {
    const bool complete = std::all_of(family.parameters.begin(), family.parameters.end(),
                                      [](const Parameter& p) { return p.fallback.has_value(); });
    EXPECT_EQ(offered.count(family.name) == 1, complete) << family.name;
  }
}

TEST(filter_table, every_field_is_fit_for_scripts_and_people) {
  for (const Filter& filter : filter_table()) {
    EXPECT_EQ(filter.name.rfind("Arete: ", 0), 0u);
    EXPECT_EQ(filter.name.find('&'), std::string::npos);
    EXPECT_NE(filter.info.find("<i>"), std::string::npos) << "no citation";
    EXPECT_NE(filter.menus, 0u);
    for (const Field& field : filter.fields({})) {
      EXPECT_TRUE(std::isupper(static_cast<unsigned char>(field.name[0]))) << field.name;
      EXPECT_TRUE(std::all_of(field.name.begin(), field.name.end(), [](unsigned char c) {
        return std::isalnum(c) && c < 128;
      })) << field.name;
      EXPECT_FALSE(field.label.empty()) << field.name;
      EXPECT_FALSE(field.tooltip.empty()) << field.name;
    }
  }
}

TEST(filter_table, names_kinds_and_order_do_not_depend_on_the_mesh) {
  for (const Filter& filter : filter_table()) {
    const auto none = filter.fields({});
    const auto large = filter.fields({1e7, true});
    ASSERT_EQ(none.size(), large.size());
    for (std::size_t i = 0; i < none.size(); ++i) {
      EXPECT_EQ(none[i].name, large[i].name);
      EXPECT_EQ(none[i].kind, large[i].kind);
      EXPECT_EQ(none[i].choices, large[i].choices);
    }
    EXPECT_NO_THROW(Values(none, {}));
    EXPECT_NO_THROW(Values(large, {}));
  }
}

TEST(filter_table, every_offered_scheme_can_be_chosen) {
  const auto fields = scheme_fields();
  for (std::size_t i = 0; i < offered_families().size(); ++i) {
    const Scheme scheme = chosen_scheme(Values(fields, {{"Scheme", double(i)}}));
    EXPECT_EQ(scheme, make_scheme(offered_families()[i]));
  }
}

TEST(filter_table, only_four_parameter_reads_the_numbers_and_text_goes_first) {
  const auto fields = scheme_fields();
  const std::map<std::string, Values::Value> numbers{
      {"Scheme", 3.0}, {"Lambda", 0.1}, {"Mu", 0.2}, {"Nu", 0.25}, {"Omega", 0.05}};
  EXPECT_EQ(chosen_scheme(Values(fields, numbers)).text(),
            "four-parameter:lambda=1/10,mu=1/5,nu=1/4,omega=1/20");
  auto with_text = numbers;
  with_text["SchemeText"] = std::string("  b-spline:degree=5 ");
  EXPECT_EQ(chosen_scheme(Values(fields, with_text)).text(), "b-spline:degree=5");
  with_text["SchemeText"] = std::string("no-such-scheme");
  EXPECT_THROW((void)chosen_scheme(Values(fields, with_text)), InvalidScheme);
  auto gentle = numbers;
  gentle["Scheme"] = 0.0;
  EXPECT_EQ(chosen_scheme(Values(fields, gentle)), make_scheme("gentle"));
}

TEST(filter_table, smoothness_says_what_is_proved_and_needs_no_mesh) {
  const Filter& filter = filter_table()[2];
  Report report;
  const Values values(filter.fields({}), {{"SchemeText", std::string("chaikin")}});
  const Outcome outcome = filter.run({}, values, report);
  EXPECT_FALSE(outcome.refined || outcome.moved);
  std::string log;
  for (const std::string& line : report.lines()) log += line + "\n";
  EXPECT_NE(log.find("C^1: certified"), std::string::npos) << log;
  EXPECT_NE(log.find("C^2: refuted"), std::string::npos) << log;
  EXPECT_NE(log.find("Hoelder exponent: 2, exactly"), std::string::npos) << log;
  EXPECT_NE(log.find("3 sum rules"), std::string::npos) << log;
  EXPECT_NE(log.find("[1/4, 3/4, 3/4, 1/4]"), std::string::npos) << log;
  EXPECT_NE(log.find("at (i + 1/2)/2"), std::string::npos) << log;
}

TEST(filter_table, a_stop_request_is_obeyed) {
  Report report([](int percent, const char*) { return percent < 20; });
  const Filter& filter = filter_table()[0];
  const auto mesh = test::grid_mesh({9, 9});
  EXPECT_THROW((void)filter.run(mesh.arrays, Values(filter.fields({}), {}), report), Cancelled);
}

}  // namespace
}  // namespace arete::meshlab

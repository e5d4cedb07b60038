// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::run_arete;
using test::run_json;

TEST(cli_validate, every_oracle_agrees_on_every_data_set) {
  const auto report = run_json({"validate", "--levels", "2", "--json"});
  std::map<std::string, int> rows;
  for (const auto& row : report.at("rows")) {
    const std::string against = row.at("against");
    EXPECT_LE(row.at("max_difference").get<double>(), row.at("allowed").get<double>()) << row;
    EXPECT_TRUE(row.at("holds").get<bool>());
    if (against.rfind("OpenSubdiv", 0) == 0) {
      EXPECT_EQ(row.at("max_difference"), 0) << row << " (all sums are exact)";
    }
    ++rows[against + " " + row.at("region").get<std::string>()];
  }
  // Every program this arete was built with, three data sets, two levels.
  EXPECT_FALSE(rows.empty());
  for (const auto& [against, count] : rows) EXPECT_EQ(count, 6) << against;
  const std::size_t possible = 6;
  EXPECT_GE(rows.size() + 2 * report.at("missing").size(), possible);
}

TEST(cli_validate, the_table_says_what_is_compared) {
  const auto run = run_arete({"validate", "--levels", "1"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_EQ(run.err, "");
  for (const char* text :
       {"max difference", "jacksboro_srtm3.tif", "random grid", "flat grid", "[1, 3, 4, 3, 1] / 6"})
    EXPECT_NE(run.out.find(text), std::string::npos) << text;
  EXPECT_EQ(run.out.find("DIFFERS"), std::string::npos);
}

TEST(cli_validate, bad_data_is_refused) {
  const auto run = run_arete({"validate", "--data", "/nowhere/dem.tif"});
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_NE(run.err.find("/nowhere/dem.tif"), std::string::npos) << run.err;
  EXPECT_EQ(run.out, "");
  EXPECT_EQ(run_arete({"validate", "--levels", "0"}).exit_code, 2);
}

}  // namespace
}  // namespace arete

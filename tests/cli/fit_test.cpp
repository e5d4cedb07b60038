// SPDX-License-Identifier: MIT
// arete fit: a complete table beside other methods, and what it refuses.
#include <gtest/gtest.h>

#include <cstring>
#include <map>

#include "expect_error.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::dem;
using test::expect_error;
using test::run_arete;
using test::run_json;

TEST(cli_fit, the_table_of_real_terrain_is_complete_and_sorted) {
  const auto report = run_json({"fit", dem, "--scheme", "four-point", "--json"});
  std::map<std::string, double> rmse;
  double before = 0;
  for (const auto& row : report.at("rows")) {
    const double value = row.at("rmse");
    EXPECT_GE(value, before);
    before = value;
    rmse[row.at("method")] = value;
  }
  for (const char* kernel : {"bilinear", "cubic", "cubicspline", "lanczos"})
    EXPECT_EQ(rmse.count(std::string("gdalwarp -r ") + kernel), 1u) << kernel;
  // One step of the four-point scheme is the cubic kernel, an oracle of its own.
  EXPECT_NEAR(rmse.at("gdalwarp -r cubic"), rmse.at("four-point:omega=1/16 (as given)"), 1e-9);
  EXPECT_LE(rmse.at("four-point fitted"), rmse.at("four-point:omega=1/16 (as given)"));
  // Smoothing kernels lose, the interpolating spline gains: measured, and to stay so.
  EXPECT_GT(rmse.at("gdalwarp -r cubicspline"), rmse.at("gdalwarp -r bilinear"));
  EXPECT_LT(rmse.at("b-spline:degree=3, interpolating"), rmse.at("gdalwarp -r cubic"));
  // Cross-validation may be lucky, but not by much.
  EXPECT_NEAR(report.at("cross_validated_rmse").get<double>(), report.at("rmse").get<double>(),
              0.05);
}

// Synthetic terrain: refined with known parameters, so that the held-out samples tell them.
TEST(cli_fit, known_parameters_are_recovered_and_the_scheme_told_can_be_used) {
  const test::TemporaryFolder folder;
  const struct {
    const char* truth;
    const char* start;
    const char* parameter;
    double value;
    const char* factor;
  } cases[]{{"four-point:omega=0.05", "four-point", "omega=", 0.05, "2"},
            {"ternary-four-point:mu=0.08", "ternary-four-point", "mu=", 0.08, "3"}};
  for (const auto& known : cases) {
    const std::string truth = folder.file(std::string(known.start) + ".tif");
    ASSERT_EQ(
        run_arete({"refine", dem, truth, "--scheme", known.truth, "--type", "float64"}).exit_code,
        0);
    const auto report =
        run_json({"fit", truth, "--scheme", known.start, "--factor", known.factor, "--json"});
    const std::string scheme = report.at("scheme");
    const auto at = scheme.find(known.parameter);
    ASSERT_NE(at, std::string::npos) << scheme;
    const std::string told = scheme.substr(at + std::strlen(known.parameter));
    const auto slash = told.find('/');
    const double value = slash == std::string::npos
                             ? std::stod(told)
                             : std::stod(told) / std::stod(told.substr(slash + 1));
    EXPECT_NEAR(value, known.value, 1e-6);
    EXPECT_LT(report.at("rmse").get<double>(), 1e-6);
    EXPECT_LT(report.at("cross_validated_rmse").get<double>(), 1e-6);
    EXPECT_TRUE(report.at("converged").get<bool>());
    EXPECT_EQ(report.at("criterion"), "rmse");
    EXPECT_GT(report.at("held_out").get<int>(), 100000);
    // What is printed can be pasted into --scheme.
    EXPECT_EQ(run_arete({"describe", scheme}).exit_code, 0);
    const std::string again = folder.file("again.tif");
    EXPECT_EQ(
        run_arete({"refine", dem, again, "--scheme", scheme, "--type", "float64", "--overwrite"})
            .exit_code,
        0);
    EXPECT_LT(run_json({"compare", truth, again, "--json"}).at("rmse").get<double>(), 1e-4);
  }
}

TEST(cli_fit, what_cannot_be_fitted_is_refused) {
  expect_error({"fit", dem, "--scheme", "gentle"}, 2, "no parameter that can move");
  expect_error({"fit", dem, "--scheme", "four-point", "--free", "lambda"}, 2,
               "no parameter 'lambda'");
  expect_error({"fit", dem, "--scheme", "four-point", "--factor", "3"}, 2, "power of the scheme's");
  expect_error({"fit", dem, "--scheme", "four-point", "--factor", "128"}, 2, "held out");
  expect_error({"fit", dem, "--scheme", "corner-cutting"}, 2, "no parameter that can move");
  expect_error({"fit", dem, "--scheme", "ternary-two-step", "--factor", "3"}, 2, "tau = ");
  expect_error({"fit", dem, "--scheme", "four-point", "--coarse", dem}, 1, "--factor-th sample");
  expect_error({"fit", "absent.tif", "--scheme", "four-point"}, 1, "does not exist");
  expect_error({"fit", dem, "--scheme", "four-point", "--max-memory", "1M"}, 1, "memory");
  expect_error({"fit", dem}, 2, "--scheme is required");
}

}  // namespace
}  // namespace arete

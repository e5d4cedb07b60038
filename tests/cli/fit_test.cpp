// SPDX-License-Identifier: MIT
// arete fit: a complete table beside other methods, and what it refuses.
#include <gtest/gtest.h>

#include <map>

#include "expect_error.h"
#include "run_program.h"

namespace arete {
namespace {

using test::dem;
using test::expect_error;
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

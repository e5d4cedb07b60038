// SPDX-License-Identifier: MIT
// arete fit: known parameters come back, the table is complete, the scheme can be pasted.
#include <gtest/gtest.h>

#include <map>

#include "arete/scheme/catalogue.h"
#include "expect_error.h"
#include "run_program.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

using test::dem;
using test::expect_error;
using test::run_arete;
using test::run_json;

std::string part_of_the_dem(const test::TemporaryFolder& folder) {
  // 101 x 86: every fourth sample.
  const std::string out = folder.file("part.tif");
  EXPECT_EQ(
      run_arete({"coarsen", dem, out, "--scheme", "four-point", "--levels", "2", "--mode", "local"})
          .exit_code,
      0);
  return out;
}

TEST(cli_fit, gives_back_the_parameters_that_made_the_terrain) {
  const test::TemporaryFolder folder;
  const std::string coarse = part_of_the_dem(folder);
  const std::string truth = folder.file("truth.tif");
  ASSERT_EQ(run_arete({"refine", coarse, truth, "--scheme",
                       "four-parameter:lambda=0.06,mu=0.06,nu=1/2,omega=0.08", "--type", "float64"})
                .exit_code,
            0);
  const auto report = run_json({"fit", truth, "--scheme", "four-parameter", "--coarse", coarse,
                                "--mode", "direct", "--json"});
  const Scheme scheme = parse_scheme(report.at("scheme").get<std::string>());
  const auto value = [&](const char* name) { return to_double(number(scheme.parameters(), name)); };
  EXPECT_NEAR(value("lambda"), 0.06, 1e-6);
  EXPECT_NEAR(value("mu"), 0.06, 1e-6);
  EXPECT_NEAR(value("omega"), 0.08, 1e-6);
  EXPECT_EQ(value("nu"), 0.5);
}

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

TEST(cli_fit, the_scheme_it_prints_can_be_pasted) {
  const test::TemporaryFolder folder;
  const std::string truth = part_of_the_dem(folder);
  const auto fit = run_arete({"fit", truth, "--scheme", "four-parameter", "--mode", "direct"});
  ASSERT_EQ(fit.exit_code, 0) << fit.err;
  const auto begin = fit.out.find("\n  four-parameter:") + 3;
  const std::string scheme = fit.out.substr(begin, fit.out.find_first_of(" \n", begin) - begin);
  EXPECT_EQ(run_arete({"refine", truth, folder.file("o.tif"), "--scheme", scheme}).exit_code, 0)
      << scheme;
}

TEST(cli_fit, by_roughness_the_spectrum_comes_nearer_than_by_rmse) {
  const auto distance = [&](const char* criterion) {
    const auto report = run_json({"fit", dem, "--scheme", "four-point", "--criterion", criterion,
                                  "--mode", "direct", "--json"});
    for (const auto& row : report.at("rows"))
      if (row.at("method") == "four-point fitted")
        return std::abs(row.at("spectral_slope").get<double>() -
                        report.at("truth_spectral_slope").get<double>());
    return 1e300;
  };
  EXPECT_LT(distance("roughness"), distance("rmse"));
}

TEST(cli_fit, what_cannot_be_fitted_is_refused) {
  expect_error({"fit", dem, "--scheme", "gentle"}, 2, "no parameter that can move");
  expect_error({"fit", dem, "--scheme", "four-point", "--free", "lambda"}, 2,
               "no parameter 'lambda'");
  expect_error({"fit", dem, "--scheme", "four-point", "--factor", "3"}, 2, "power of the scheme's");
  expect_error({"fit", dem, "--scheme", "four-point", "--factor", "128"}, 2, "held out");
  expect_error({"fit", dem, "--scheme", "corner-cutting"}, 2, "tau = 0");
  expect_error({"fit", dem, "--scheme", "four-point", "--coarse", dem}, 1, "--factor-th sample");
  expect_error({"fit", "absent.tif", "--scheme", "four-point"}, 1, "does not exist");
  expect_error({"fit", dem, "--scheme", "four-point", "--max-memory", "1M"}, 1, "memory");
  expect_error({"fit", dem}, 2, "--scheme is required");
}

}  // namespace
}  // namespace arete

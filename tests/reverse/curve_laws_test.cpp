// SPDX-License-Identifier: MIT
// Laws of reverse subdivision along one axis, for every scheme of the catalogue that has one.
#include <gtest/gtest.h>

#include <map>

#include "arete/analysis/polynomial.h"
#include "arete/refine/curve.h"
#include "arete/reverse/curve_reverse.h"
#include "rational_grid.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

using test::relative_difference;

constexpr Boundary boundaries[] = {Boundary::extrapolate, Boundary::clamp, Boundary::reflect,
                                   Boundary::periodic};

CurveReverseOptions options_with(int levels, ReverseMode mode, Boundary boundary) {
  return {levels, mode, boundary == Boundary::periodic, boundary};
}

// Nothing when the scheme is refused.
std::optional<Decomposition<double>> parts_of(const Grid<double>& fine, const Scheme& scheme,
                                              const CurveReverseOptions& options) {
  try {
    return decompose<double>(fine.view(), scheme, options);
  } catch (const InvalidScheme&) {
    return std::nullopt;
  }
}

TEST(reverse_curve, which_schemes_have_a_local_reverse) {
  std::map<std::string, LocalRule> wanted{
      {"four-point", LocalRule::interpolatory},
      {"four-point:omega=0.03", LocalRule::interpolatory},
      {"three-point", LocalRule::interpolatory},
      {"ternary-two-step-9", LocalRule::interpolatory},
      {"ternary-four-point", LocalRule::interpolatory},
      {"b-spline:degree=1", LocalRule::interpolatory},
      {"dubuc-deslauriers:points=6", LocalRule::interpolatory},
      {"dubuc-deslauriers:points=8", LocalRule::interpolatory},
      {"chaikin", LocalRule::corner_cutting},
      {"de-rham", LocalRule::corner_cutting},
      {"corner-cutting:u=1/5,v=3/10", LocalRule::corner_cutting},
      {"b-spline:degree=2", LocalRule::corner_cutting},
      {"b-spline:degree=3", LocalRule::five_coefficients},
      {"gentle", LocalRule::none},
      {"ternary-two-step", LocalRule::none}};
  for (const auto& [text, rule] : wanted)
    EXPECT_EQ(local_rule(parse_scheme(text).mask()), rule) << text;
}

// Members whose shift leaves a coarse sample at an open end without its local filter.
bool may_be_refused(const Scheme& scheme, ReverseMode mode, Boundary boundary) {
  return mode == ReverseMode::local && boundary != Boundary::periodic &&
         scheme.name() == "two-parameter";
}

// Members whose least-squares problem is badly conditioned of itself.
double tolerance(const Scheme& scheme) {
  const bool wild =
      scheme.name() == "difference" || scheme.text() == "three-parameter:a=1/5,c=-1/3,m=2,raise=1";
  return wild ? 1e-9 : 1e-12;
}

TEST(reverse_curve, identity_for_every_size_mode_boundary_and_number_of_levels) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      if (mode == ReverseMode::local && local_rule(scheme.mask()) == LocalRule::none) continue;
      for (const Boundary boundary : boundaries) {
        const std::string what = scheme.text() + ", " + std::string(to_string(mode)) + ", " +
                                 std::string(to_string(boundary));
        const bool usual = boundary == Boundary::extrapolate || boundary == Boundary::periodic;
        double worst = 0;
        int refused = 0;
        for (Index size = 1; size <= (usual ? 200 : 40); ++size) {
          const Grid<double> fine = test::random_heights({size, 2}, static_cast<unsigned>(size));
          for (int levels = 1; levels <= 5; levels += size % 7 == 0 ? 1 : 4) {
            const auto parts = parts_of(fine, scheme, options_with(levels, mode, boundary));
            if (!parts) {
              ++refused;
              continue;
            }
            worst = std::max(worst, relative_difference(reconstruct(*parts), fine));
            ASSERT_EQ(parts->details.size(), static_cast<std::size_t>(levels));
            const int padding = boundary == Boundary::periodic ? scheme.mask().arity() - 1 : 0;
            ASSERT_GE(parts->vectors(), size) << what;
            ASSERT_LE(parts->vectors(), size + levels * padding) << what;
          }
        }
        EXPECT_LE(worst, tolerance(scheme)) << what;
        EXPECT_EQ(refused > 0, may_be_refused(scheme, mode, boundary)) << what;
      }
    }
  }
}

TEST(reverse_curve, identity_is_exact_over_rationals) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      if (mode == ReverseMode::local && local_rule(scheme.mask()) == LocalRule::none) continue;
      for (const Boundary boundary : {Boundary::extrapolate, Boundary::periodic}) {
        for (const Index size : {1, 2, 3, 7, 12}) {
          const auto fine = test::random_integers<Rational>({size, 1}, 5);
          const auto options = options_with(2, mode, boundary);
          try {
            const auto parts = decompose<Rational>(fine.view(), scheme, options);
            test::expect_exact(reconstruct(parts), fine, scheme.text());
          } catch (const InvalidScheme&) {
            EXPECT_TRUE(may_be_refused(scheme, mode, boundary)) << scheme.text();
          }
        }
      }
    }
  }
}

// `levels` single steps of the engine: every level makes its own ghosts.
Grid<double> refined_step_by_step(Grid<double> points, const Scheme& scheme, int levels,
                                  Boundary boundary) {
  for (int level = 0; level < levels; ++level)
    points =
        refine_curve<double>(points.view(), scheme, {1, boundary == Boundary::periodic, boundary})
            .points;
  return points;
}

double largest(const Grid<double>& grid) {
  double value = 0;
  for (const double v : grid.samples()) value = std::max(value, std::abs(v));
  return value;
}

TEST(reverse_curve, what_was_refined_comes_back_with_zero_details) {
  for (const Scheme& scheme : test::sample_schemes()) {
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      if (mode == ReverseMode::local && local_rule(scheme.mask()) == LocalRule::none) continue;
      for (const Boundary boundary : boundaries) {
        for (const Index size : {2, 3, 4, 5, 9, 16, 33}) {
          const Grid<double> coarse = test::random_heights({size, 2}, 3);
          const int levels = scheme.mask().arity() > 4 ? 1 : 3;
          const Grid<double> fine = refined_step_by_step(coarse, scheme, levels, boundary);
          const auto parts = parts_of(fine, scheme, options_with(levels, mode, boundary));
          if (!parts) {
            EXPECT_TRUE(may_be_refused(scheme, mode, boundary)) << scheme.text();
            continue;
          }
          const std::string what = scheme.text() + ", " + std::string(to_string(mode)) + ", " +
                                   std::string(to_string(boundary)) + ", " + std::to_string(size);
          const double close = 1000 * tolerance(scheme);
          ASSERT_LE(relative_difference(parts->coarse, coarse), close) << what;
          for (const auto& details : parts->details)
            ASSERT_LE(largest(details), 1e3 * close) << what;
        }
      }
    }
  }
}

TEST(reverse_curve, dyadic_local_filters_are_exact_in_floating_point) {
  for (const char* name : {"chaikin", "b-spline:degree=2", "b-spline:degree=3", "four-point",
                           "b-spline:degree=1", "dubuc-deslauriers:points=6"}) {
    const Scheme scheme = parse_scheme(name);
    for (const Boundary boundary : {Boundary::extrapolate, Boundary::periodic}) {
      for (const Index size : {7, 16, 61}) {
        const auto options = options_with(3, ReverseMode::local, boundary);
        const auto any = test::random_integers<double>({size, 2}, 9);
        const auto parts = decompose<double>(any.view(), scheme, options);
        EXPECT_EQ(reconstruct(parts).samples(), any.samples()) << name;
        const Grid<double> fine = refined_step_by_step(any, scheme, 3, boundary);
        const auto smooth = decompose<double>(fine.view(), scheme, options);
        EXPECT_EQ(smooth.coarse.samples(), any.samples()) << name;
        for (const auto& details : smooth.details) EXPECT_EQ(largest(details), 0) << name;
      }
    }
  }
}

TEST(reverse_curve, several_levels_of_the_engine_come_back_from_closed_and_cubic_curves) {
  const Grid<double> coarse = test::random_heights({12, 2}, 5);
  for (const bool closed : {true, false}) {
    for (const char* name : {"chaikin", "four-point", "b-spline:degree=3", "gentle"}) {
      if (!closed && std::string(name) != "b-spline:degree=3") continue;
      const Scheme scheme = parse_scheme(name);
      const auto fine =
          refine_curve<double>(coarse.view(), scheme, {3, closed, Boundary::extrapolate});
      const auto parts =
          decompose<double>(fine.points.view(), scheme,
                            {3, ReverseMode::least_squares, closed, Boundary::extrapolate});
      EXPECT_LE(relative_difference(parts.coarse, coarse), 1e-12) << name;
      for (const auto& details : parts.details) EXPECT_LE(largest(details), 1e-9) << name;
    }
  }
}

TEST(reverse_curve, least_squares_leaves_the_smallest_residual) {
  std::mt19937 random(2);
  std::normal_distribution<double> number(0, 1);
  for (const Scheme& scheme : test::sample_schemes()) {
    for (const Boundary boundary : {Boundary::extrapolate, Boundary::periodic}) {
      const Grid<double> fine = test::random_heights({144, 1});  // every arity divides it
      const auto residual = [&](Decomposition<double> parts, double shake) {
        for (double& detail : parts.details.front().samples()) detail = 0;
        for (double& value : parts.coarse.samples()) value += shake * number(random);
        const Grid<double> smooth = reconstruct(parts);
        double sum = 0;
        for (std::size_t i = 0; i < fine.samples().size(); ++i)
          sum += std::pow(fine.samples()[i] - smooth.samples()[i], 2);
        return std::sqrt(sum);
      };
      const auto best = decompose<double>(fine.view(), scheme,
                                          options_with(1, ReverseMode::least_squares, boundary));
      const double least = residual(best, 0);
      for (const double shake : {1e-2, 1.0})
        EXPECT_GT(residual(best, shake), least) << scheme.text() << to_string(boundary);
      if (local_rule(scheme.mask()) == LocalRule::none) continue;
      const auto other = parts_of(fine, scheme, options_with(1, ReverseMode::local, boundary));
      if (other) {
        EXPECT_GE(residual(*other, 0), least) << scheme.text();
      }
    }
  }
}

TEST(reverse_curve, lines_stay_where_they_are) {
  // For schemes with two sum rules the coarse samples of f_i = i are their own positions.
  for (const Scheme& scheme : test::sample_schemes()) {
    if (sum_rules(scheme.mask()) < 2) continue;
    for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
      if (mode == ReverseMode::local && local_rule(scheme.mask()) == LocalRule::none) continue;
      for (const Index size : {5, 17, 40, 41, 42, 85}) {
        const Grid<double> line = test::plane<double>({size, 1}, 0, 1, 0);
        const auto parts = parts_of(line, scheme, options_with(2, mode, Boundary::extrapolate));
        if (!parts) continue;
        if (parts->coarse.rows() < 2) continue;
        EXPECT_EQ(parts->placement.count, parts->coarse.rows());
        for (Index j = 0; j < parts->coarse.rows(); ++j)
          EXPECT_NEAR(parts->coarse(j, 0),
                      parts->placement.first + static_cast<double>(j) * parts->placement.spacing,
                      1e-7)
              << scheme.text() << " " << size;
        for (const auto& details : parts->details)
          EXPECT_LE(largest(details), 1e-7) << scheme.text();
      }
    }
  }
}

TEST(reverse_curve, counts_are_those_documented) {
  const auto sizes = [](const char* scheme, Index size, Boundary boundary) {
    const auto parts = decompose<double>(Grid<double>({size, 1}).view(), parse_scheme(scheme),
                                         options_with(3, ReverseMode::least_squares, boundary));
    return parts.sizes;
  };
  using Sizes = std::vector<Index>;
  EXPECT_EQ(sizes("four-point", 33, Boundary::extrapolate), (Sizes{33, 17, 9, 5}));
  EXPECT_EQ(sizes("four-point", 344, Boundary::extrapolate), (Sizes{344, 172, 86, 43}));
  EXPECT_EQ(sizes("chaikin", 8, Boundary::extrapolate), (Sizes{8, 5, 3, 2}));
  EXPECT_EQ(sizes("chaikin", 13, Boundary::periodic), (Sizes{13, 7, 4, 2}));
  EXPECT_EQ(sizes("ternary-two-step", 28, Boundary::periodic), (Sizes{28, 10, 4, 2}));
  EXPECT_EQ(sizes("ternary-two-step-9", 82, Boundary::extrapolate), (Sizes{82, 10, 2, 1}));
  EXPECT_EQ(sizes("chaikin", 1, Boundary::periodic), (Sizes{1, 1, 1, 1}));
}

// Root mean square error of the coarse samples for white noise of variance 1 on 16 m fine samples.
double noise_gain(const char* scheme, ReverseMode mode) {
  const Scheme s = parse_scheme(scheme);
  const Index n = 16;
  const Index fine = n * s.mask().arity();
  Grid<double> impulses({fine, fine});
  for (Index i = 0; i < fine; ++i) impulses(i, i) = 1;
  const auto parts = decompose<double>(impulses.view(), s, {1, mode, true, {}});
  double sum = 0;
  for (const double weight : parts.coarse.samples()) sum += weight * weight;
  return std::sqrt(sum / static_cast<double>(n));
}

TEST(reverse_curve, noise_gains_are_those_of_the_specification) {
  const auto local = ReverseMode::local;
  const auto best = ReverseMode::least_squares;
  EXPECT_NEAR(noise_gain("chaikin", local), 1.118, 5e-4);
  EXPECT_NEAR(noise_gain("chaikin", best), 1.000, 5e-4);
  EXPECT_NEAR(noise_gain("b-spline:degree=3", local), 2.121, 5e-4);
  EXPECT_NEAR(noise_gain("b-spline:degree=3", best), 1.210, 5e-4);
  EXPECT_NEAR(noise_gain("four-point", local), 1.000, 5e-4);
  EXPECT_NEAR(noise_gain("four-point", best), 0.804, 5e-4);
  EXPECT_NEAR(noise_gain("ternary-two-step:b=1/10", best), 0.648, 5e-4);
}

TEST(reverse_curve, coordinates_do_not_see_each_other) {
  const Grid<double> both = test::random_heights({41, 2});
  Grid<double> one({41, 1});
  for (Index i = 0; i < 41; ++i) one(i, 0) = both(i, 1);
  for (const ReverseMode mode : {ReverseMode::local, ReverseMode::least_squares}) {
    const auto options = options_with(2, mode, Boundary::extrapolate);
    const auto a = decompose<double>(both.view(), parse_scheme("chaikin"), options);
    const auto b = decompose<double>(one.view(), parse_scheme("chaikin"), options);
    for (Index j = 0; j < a.coarse.rows(); ++j) EXPECT_EQ(a.coarse(j, 1), b.coarse(j, 0));
  }
}

TEST(reverse_curve, progressive_reconstruction_is_a_shorter_decomposition) {
  const Grid<double> fine = test::random_heights({100, 2});
  const Scheme scheme = parse_scheme("gentle");
  const auto parts =
      decompose<double>(fine.view(), scheme, {4, ReverseMode::least_squares, true, {}});
  for (int steps = 0; steps <= 4; ++steps) {
    const auto shorter =
        decompose<double>(fine.view(), scheme, {4 - steps, ReverseMode::least_squares, true, {}});
    EXPECT_LE(relative_difference(reconstruct(parts, steps), shorter.coarse), 1e-12);
  }
}

TEST(reverse_curve, misuse_is_refused) {
  const Grid<double> fine = test::random_heights({10, 2});
  const Scheme scheme = parse_scheme("chaikin");
  const auto with = [&](const Scheme& s, CurveReverseOptions options) {
    return decompose<double>(fine.view(), s, options);
  };
  EXPECT_THROW((void)with(scheme, {-1, {}, false, {}}), InvalidField);
  EXPECT_THROW((void)with(scheme, {1, {}, false, Boundary::none}), InvalidField);
  EXPECT_THROW((void)decompose<double>(Grid<double>({0, 2}).view(), scheme, {}), InvalidField);
  EXPECT_THROW((void)decompose<double>(Grid<double>({2, 0}).view(), scheme, {}), InvalidField);
  EXPECT_THROW((void)with(parse_scheme("gentle"), {1, ReverseMode::local, false, {}}),
               InvalidScheme);
  // u + v = 1: both new points of an edge coincide; u = v = 1/2 even vanishes at z = -1.
  const Scheme flat = parse_scheme("corner-cutting:u=1/2,v=1/2");
  EXPECT_THROW((void)with(flat, {1, ReverseMode::local, true, {}}), InvalidScheme);
  EXPECT_THROW((void)with(flat, {1, ReverseMode::least_squares, true, {}}), InvalidScheme);
  auto parts = with(scheme, {2, {}, false, {}});
  EXPECT_THROW((void)reconstruct(parts, 3), InvalidField);
  parts.coarse = Grid<double>({3, 2});
  EXPECT_THROW((void)reconstruct(parts), InvalidField);
}

}  // namespace
}  // namespace arete

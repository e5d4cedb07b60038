// SPDX-License-Identifier: MIT
// The natural cubic spline: oracle records exactly, its laws, its edges.
#include "arete/variational/natural_spline.h"

#include <gtest/gtest.h>

#include "arete/algebra/rational.h"
#include "arete/fractal/curve_system.h"
#include "arete/fractal/ifs.h"
#include "arete/fractal/pairs.h"
#include "support/oracle.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact;
using test::exact_list;
using test::ternary_and_reverse_records;
using Rationals = std::vector<Rational>;

Matrix<Rational> column(const Rationals& values) {
  Matrix<Rational> points(static_cast<int>(values.size()), 1);
  for (int i = 0; i < points.rows(); ++i) points(i, 0) = values[static_cast<std::size_t>(i)];
  return points;
}

Rationals entries(const Matrix<Rational>& points) {
  Rationals values;
  for (int i = 0; i < points.rows(); ++i) values.push_back(points(i, 0));
  return values;
}

TEST(natural_spline, records) {
  for (const json& record : ternary_and_reverse_records("r.spline")) {
    const std::string id = record.at("id");
    const json& expect = record.at("expect");
    const NaturalSpline<Rational> spline(column(exact_list(record.at("input").at("v"))));
    EXPECT_EQ(entries(spline.control()), exact_list(expect.at("control"))) << id;
    EXPECT_EQ(entries(spline.refined(1)), exact_list(expect.at("control_after_one_refinement")))
        << id;
    EXPECT_EQ(spline.bending_energy(), exact(expect.at("bending_energy"))) << id;
    for (const auto& [at, value] : expect.at("values").items()) {
      const Rational t = parse_rational(at);
      const int pieces = spline.control().rows() - 1;
      const Rational parameter =
          t > pieces ? Rational(t - pieces) : t;  // n = 1 is asked at 3/4 too
      const int knot = std::min(pieces - 1, static_cast<int>(floor(parameter)));
      EXPECT_EQ(spline.value(knot, parameter - knot).front(), exact(value)) << id << " at " << at;
    }
  }
}

TEST(natural_spline, matrices_of_the_records) {
  for (const json& record : ternary_and_reverse_records("r.spline_matrices")) {
    const json& rows = record.at("expect").at("C");
    const auto c = natural_spline_matrix<Rational>(record.at("input").at("n").get<int>());
    for (int i = 0; i < c.rows(); ++i)
      for (int j = 0; j < c.cols(); ++j)
        EXPECT_EQ(c(i, j), exact(rows[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]));
  }
}

Rationals some_values(int n) {
  Rationals values;
  for (int i = 0; i < n; ++i) values.emplace_back((7 * i * i + 5 * i) % 13 - 6, i % 2 + 1);
  return values;
}

TEST(natural_spline, passes_through_its_points_at_every_level) {
  for (const SplineEnds ends : {SplineEnds::natural, SplineEnds::closed})
    for (int n = 1; n <= 9; ++n) {
      const Rationals values = some_values(n);
      const NaturalSpline<Rational> spline(column(values), ends);
      for (int levels : {0, 1, 3}) {
        const auto points = spline.points(levels);
        for (int i = 0; i < n; ++i)
          EXPECT_EQ(points(i << levels, 0), values[static_cast<std::size_t>(i)]) << n;
        if (n == 1) continue;
        const int pieces = ends == SplineEnds::closed ? n : n - 1;
        EXPECT_EQ(points.rows(), (pieces << levels) + (ends == SplineEnds::closed ? 0 : 1));
        // And between them is the piecewise cubic.
        for (int i = 0; i < pieces << levels; ++i)
          EXPECT_EQ(points(i, 0),
                    spline.value(i >> levels, Rational(i % (1 << levels), 1 << levels)).front());
      }
    }
}

TEST(natural_spline, is_twice_differentiable_and_ends_without_bending) {
  const NaturalSpline<Rational> spline(column(some_values(7)));
  const auto second = spline.second_derivatives(0);
  EXPECT_EQ(second(0, 0), 0);
  EXPECT_EQ(second(6, 0), 0);
  // Derivatives of the cubic pieces by exact interpolation at four parameters of each piece.
  const auto first = spline.derivatives(0);
  for (int knot = 0; knot < 6; ++knot) {
    const auto f = [&](int i) { return spline.value(knot, Rational(i, 3)).front(); };
    // f'(0) and f'(1) of the cubic through f(0), f(1/3), f(2/3), f(1), and the second ones.
    EXPECT_EQ((-11 * f(0) + 18 * f(1) - 9 * f(2) + 2 * f(3)) / 2, first(knot, 0));
    EXPECT_EQ((11 * f(3) - 18 * f(2) + 9 * f(1) - 2 * f(0)) / 2, first(knot + 1, 0));
    EXPECT_EQ(9 * (2 * f(0) - 5 * f(1) + 4 * f(2) - f(3)), second(knot, 0));
    EXPECT_EQ(9 * (2 * f(3) - 5 * f(2) + 4 * f(1) - f(0)), second(knot + 1, 0));
  }
}

// The arcs of four control points, iterated, are the spline's polygon refined.
TEST(natural_spline, is_the_attractor_of_its_arcs) {
  for (int n : {2, 3, 6}) {
    const NaturalSpline<Rational> spline(column(some_values(n)));
    const CurveSystem system = parse_curve_system("natural-spline", n);
    const auto arcs = cut_into_arcs(system, spline.control(), /*closed=*/false);
    ASSERT_EQ(static_cast<int>(arcs.size()), n - 1);
    const auto fine = spline.refined(3);
    const auto limit = spline.points(3);
    const auto start = fixed_row(system.set[0]).value();
    int i = 0;
    for (const auto& arc : arcs)
      Ifs<Rational>(system.set, arc).visit_arcs(3, [&](const Matrix<Rational>& part) {
        EXPECT_EQ(part(1, 0), fine(i, 0));
        EXPECT_EQ(part(2, 0), fine(i + 1, 0));
        Rational on_curve = 0;
        for (int r = 0; r < 4; ++r) on_curve += start[static_cast<std::size_t>(r)] * part(r, 0);
        EXPECT_EQ(on_curve, limit(i, 0));
        ++i;
      });
    EXPECT_EQ(i, 8 * (n - 1));
  }
}

// The printed pair is one step of it, exactly; iterated it is another curve, which misses the data.
TEST(natural_spline, is_not_the_attractor_of_the_printed_pair) {
  const NaturalSpline<Rational> spline(column({1, 3, 3, 4, 2}));
  const Ifs<Rational> ifs(cubic_spline_pair<Rational>(4), spline.control());
  const auto once = spline.refined(1);
  int number = 0;
  ifs.visit_arcs(1, [&](const Matrix<Rational>& arc) {
    for (int r = 0; r < 5; ++r) EXPECT_EQ(arc(r, 0), once(4 * number + r, 0));
    ++number;
  });
  EXPECT_EQ(spline.value(2, 0).front(), 3);
  for (int depth = 1; depth <= 6; ++depth)
    EXPECT_EQ(ifs.points(depth)(1 << (depth - 1), 0), Rational(159, 56));
}

// The integral of (F'')^2 of the cubic Hermite pieces with these values and slopes, exactly.
Rational hermite_energy(const Rationals& v, const Rationals& slopes) {
  Rational energy = 0;
  for (std::size_t i = 0; i + 1 < v.size(); ++i) {
    const Rational rise = v[i + 1] - v[i];
    const Rational &a = slopes[i], &b = slopes[i + 1];
    energy += 4 * (a * a + a * b + b * b) - 12 * rise * (a + b) + 12 * rise * rise;
  }
  return energy;
}

TEST(natural_spline, bends_least_among_its_competitors) {
  const Rationals values = some_values(6);
  const NaturalSpline<Rational> spline(column(values));
  const Rationals slopes = entries(spline.derivatives(0));
  const Rational least = spline.bending_energy();
  EXPECT_EQ(hermite_energy(values, slopes), least);
  for (std::size_t i = 0; i < slopes.size(); ++i)
    for (const Rational& change :
         {Rational(1, 1000), Rational(-1, 1000), Rational(1), Rational(-2)}) {
      Rationals other = slopes;
      other[i] += change;
      EXPECT_GT(hermite_energy(values, other), least) << i << ' ' << change;
    }
}

TEST(natural_spline, closed_does_not_care_where_it_begins) {
  Rationals values = some_values(7);
  const auto points =
      entries(NaturalSpline<Rational>(column(values), SplineEnds::closed).points(2));
  std::rotate(values.begin(), values.begin() + 3, values.end());
  auto turned = entries(NaturalSpline<Rational>(column(values), SplineEnds::closed).points(2));
  std::rotate(turned.begin(), turned.end() - 12, turned.end());
  EXPECT_EQ(turned, points);
}

TEST(natural_spline, keeps_lines_and_follows_rotations) {
  Matrix<double> points(6, 2);
  for (int i = 0; i < 6; ++i) {
    points(i, 0) = i;
    points(i, 1) = (i * i * 5) % 7;
  }
  const double c = std::cos(0.7), s = std::sin(0.7);
  Matrix<double> turned(6, 2);
  for (int i = 0; i < 6; ++i) {
    turned(i, 0) = c * points(i, 0) - s * points(i, 1);
    turned(i, 1) = s * points(i, 0) + c * points(i, 1);
  }
  const auto fine = NaturalSpline<double>(points).points(4);
  const auto fine_turned = NaturalSpline<double>(turned).points(4);
  for (int i = 0; i < fine.rows(); ++i) {
    EXPECT_NEAR(fine(i, 0), i / 16.0, 1e-12);  // the abscissae are linear
    EXPECT_NEAR(fine_turned(i, 0), c * fine(i, 0) - s * fine(i, 1), 1e-12);
    EXPECT_NEAR(fine_turned(i, 1), s * fine(i, 0) + c * fine(i, 1), 1e-12);
  }
}

TEST(natural_spline, of_nothing_is_refused_and_of_few_points_is_what_it_can_be) {
  EXPECT_THROW(NaturalSpline<Rational>(Matrix<Rational>(0, 2)), InvalidField);
  EXPECT_THROW(NaturalSpline<Rational>(Matrix<Rational>(2, 0)), InvalidField);
  EXPECT_EQ(entries(NaturalSpline<Rational>(column({5})).points(3)), (Rationals{5}));
  EXPECT_EQ(entries(NaturalSpline<Rational>(column({1, 2})).points(1)),
            (Rationals{1, Rational(3, 2), 2}));
  EXPECT_EQ(entries(NaturalSpline<Rational>(column({3, 3, 3})).points(1)),
            (Rationals{3, 3, 3, 3, 3}));
  EXPECT_EQ(entries(NaturalSpline<Rational>(column({1, 2}), SplineEnds::closed).points(1)),
            (Rationals{1, Rational(3, 2), 2, Rational(3, 2)}));
}

}  // namespace
}  // namespace arete

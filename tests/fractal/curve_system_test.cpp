// SPDX-License-Identifier: MIT
// Curves made of arcs: any scheme, chains of Bezier curves, contours.
#include "arete/fractal/curve_system.h"

#include <gtest/gtest.h>

#include <numbers>

#include "arete/algebra/characteristic_polynomial.h"
#include "arete/analysis/joint_spectral_radius.h"
#include "arete/analysis/limit_stencil.h"
#include "arete/fractal/arc_matrices.h"
#include "arete/fractal/difference_matrices.h"
#include "arete/fractal/goldman.h"
#include "arete/fractal/ifs.h"
#include "arete/refine/reference.h"
#include "support.h"
#include "support/schemes.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact;
using test::exact_matrix;
using test::ternary_and_reverse_records;

TEST(fractal_curve_system, corner_cutting_of_the_records) {
  for (const json& record : ternary_and_reverse_records("r.corner_cut")) {
    const json& input = record.at("input");
    const MatrixSet<Rational> pair =
        corner_cutting_pair(exact(input.at("u")), exact(input.at("v")));
    const auto control = exact_matrix(input.at("points"));
    ASSERT_FALSE(input.at("closed").get<bool>());
    ASSERT_EQ(control.rows(), 3);
    // An open polygon of three points cut k times: the arcs' windows of three, each one further.
    const int steps = input.at("steps");
    const Ifs<Rational> ifs(pair, control);
    std::vector<Matrix<Rational>> arcs;
    ifs.visit_arcs(steps, [&arcs](const Matrix<Rational>& arc) { arcs.push_back(arc); });
    const auto expected = exact_matrix(record.at("expect").at("points"));
    ASSERT_EQ(expected.rows(), static_cast<int>(arcs.size()) + 2);
    for (std::size_t k = 0; k < arcs.size(); ++k)
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 2; ++c)
          EXPECT_EQ(arcs[k](r, c), expected(static_cast<int>(k) + r, c)) << record.at("id");
  }
}

TEST(fractal_arc_matrices, of_corner_cutting_and_splines_are_the_named_pairs) {
  const auto pair = corner_cutting_pair(Rational(1, 5), Rational(3, 10));
  EXPECT_EQ(arc_matrices(parse_scheme("corner-cutting:u=1/5,v=3/10").mask()).set,
            MatrixSet<Rational>(pair));
  // Inside, the spline pair is the scheme's: rows 2.. of L on the middle columns.
  const auto spline = arc_matrices(parse_scheme("b-spline:degree=3").mask());
  EXPECT_EQ(spline.first, -1);
  ASSERT_EQ(spline.set.size(), 4);
  const auto five = cubic_spline_pair<Rational>(4);
  for (int s = 0; s < 3; ++s) {
    EXPECT_EQ(spline.set[0](1, s), five.left(2, s));
    EXPECT_EQ(spline.set[0](2, s), five.left(3, s + (0)));
  }
}

// The arcs' control points at depth k are the polygon refined k times, exactly, for every scheme.
TEST(fractal_arc_matrices, arcs_are_windows_of_the_refined_polygon) {
  for (const Scheme& scheme : test::sample_schemes()) {
    SCOPED_TRACE(scheme.text());
    const ArcMatrices arcs = arc_matrices(scheme.mask());
    const int n = arcs.set.size();
    const int m = scheme.mask().arity();
    for (const Matrix<Rational>& map : arcs.set.maps) ASSERT_TRUE(rows_sum_to_one(map));
    const int depth = m > 3 ? 1 : 2;
    const auto control = test::some_points(n);
    // Level by level with the mask itself; index 0 is the parameter 0 of the arc.
    std::vector<Rational> level;
    for (int i = 0; i < n; ++i) level.push_back(control(i, 1));
    int first = arcs.first;
    for (int step = 0; step < depth; ++step) {
      const LevelRule rule{m, scheme.mask().symbol()};
      const IndexRange coarse{first, first + static_cast<int>(level.size()) - 1};
      const IndexRange fine = rule.computable(coarse);
      level = apply_rule(PhasedRule<Rational>(rule), level, first, fine);
      first = static_cast<int>(fine.first);
    }
    int number = 0;
    Ifs<Rational>(arcs.set, control).visit_arcs(depth, [&](const Matrix<Rational>& arc) {
      for (int r = 0; r < n; ++r) {
        const int index = number + arcs.first + r - first;
        ASSERT_GE(index, 0);
        ASSERT_LT(index, static_cast<int>(level.size()));
        ASSERT_EQ(arc(r, 1), level[static_cast<std::size_t>(index)]);
      }
      ++number;
    });
  }
}

TEST(fractal_limit_stencil, at_integers_is_the_limit_stencil_of_the_scheme) {
  int compared = 0;
  for (const Scheme& scheme : test::sample_schemes()) {
    const auto expected = limit_stencil(scheme.mask());
    if (!expected) continue;
    EXPECT_EQ(limit_stencil_at(scheme.mask(), 0), expected) << scheme.text();
    Stencil moved = *expected;
    moved.first -= 2;
    EXPECT_EQ(limit_stencil_at(scheme.mask(), -2), moved) << scheme.text();
    ++compared;
  }
  EXPECT_GT(compared, 20);
}

TEST(fractal_limit_stencil, at_fractions_is_the_spline) {
  const Mask cubic = parse_scheme("b-spline:degree=3").mask();
  for (const Rational& t : {Rational(1, 3), Rational(2, 5), Rational(5, 8), Rational(6, 7)}) {
    const Rational s = 1 - t;
    const std::vector<Rational> weights{s * s * s / 6, (4 - 6 * t * t + 3 * t * t * t) / 6,
                                        (4 - 6 * s * s + 3 * s * s * s) / 6, t * t * t / 6};
    EXPECT_EQ(limit_stencil_at(cubic, t), (Stencil{-1, weights}));
  }
  // The quadratic spline at the middle of its cell, seen from either side.
  const Mask chaikin = parse_scheme("chaikin").mask();
  const std::vector<Rational> eighths{Rational(1, 8), Rational(3, 4), Rational(1, 8)};
  EXPECT_EQ(limit_stencil_at(chaikin, Rational(1, 2)), (Stencil{0, eighths}));
  EXPECT_EQ(limit_stencil_at(chaikin, Rational(-1, 2)), (Stencil{-1, eighths}));
  // An expansion too long to carry.
  EXPECT_EQ(limit_stencil_at(chaikin, Rational(1, 1000003)), std::nullopt);
}

TEST(fractal_address, a_parameter_outside_the_arc_is_refused_and_the_end_is_in) {
  const MatrixSet<Rational> bezier = bezier_pair<Rational>(2);
  EXPECT_EQ(limit_row(bezier, 1, 10), (std::vector<Rational>{0, 0, 1}));
  EXPECT_EQ(limit_row(bezier, Rational(1, 3), 10),
            (std::vector<Rational>{Rational(4, 9), Rational(4, 9), Rational(1, 9)}));
  EXPECT_THROW((void)limit_row(bezier, Rational(4, 3), 10), std::invalid_argument);
  EXPECT_EQ(fixed_row(Matrix<Rational>::identity(2)), std::nullopt);
}

TEST(fractal_difference_matrices, of_corner_cutting) {
  const Rational u(1, 5);
  const Rational v(2, 7);
  const auto d = difference_matrices<Rational>(corner_cutting_pair(u, v));
  EXPECT_EQ(d[0], matrix_of_rows<Rational>({{1 - u - v, 0}, {v, u}}));
  EXPECT_EQ(d[1], matrix_of_rows<Rational>({{v, u}, {0, 1 - u - v}}));
}

// The spectra alone would promise more: the exponent is that of the joint spectral radius.
TEST(fractal_difference_matrices, their_joint_spectral_radius_is_that_of_the_records) {
  for (const json& record : ternary_and_reverse_records("r.uv_jsr")) {
    const Rational u = exact(record.at("input").at("u"));
    const Rational v = exact(record.at("input").at("v"));
    const double expected = record.at("expect").at("jsr_of_difference_matrices");
    const auto d = difference_matrices<Rational>(corner_cutting_pair(u, v));
    // From below: the largest |eigenvalue|^(1/length) over all words.
    double from_words = 0;
    for (int length = 1; length <= 8; ++length)
      for (int word = 0; word < (1 << length); ++word) {
        Address address;
        for (int i = 0; i < length; ++i) address.push_back((word >> i) & 1);
        const auto product = to_double(address_product(d, address));
        const double trace = (product(0, 0) + product(1, 1)) / 2;
        const double det = product(0, 0) * product(1, 1) - product(0, 1) * product(1, 0);
        const double radius = std::abs(trace) + std::sqrt(std::max(0.0, trace * trace - det));
        from_words = std::max(from_words, std::pow(radius, 1.0 / length));
      }
    EXPECT_NEAR(from_words, expected, 1e-9) << record.at("id");
    // From above: the proved bound for the difference scheme of the same mask.
    const Mask mask = make_scheme("corner-cutting", {{"u", {u}}, {"v", {v}}}).mask();
    const auto bounds =
        joint_spectral_radius(2, mask.symbol().divided_by_smoothing_factor(2).value());
    EXPECT_NEAR(to_double(bounds.upper), expected, 1e-8) << record.at("id");
    EXPECT_NEAR(-std::log2(expected),
                record.at("expect").at("hoelder_exponent_dyadic_parameter").get<double>(), 1e-9);
  }
}

TEST(fractal_curve_system, a_contour_is_a_set_of_systems) {
  for (const json& record : ternary_and_reverse_records("r.contour_ifs")) {
    const json& expect = record.at("expect");
    const auto polygon = exact_matrix(record.at("input").at("closed_polygon"));
    const CurveSystem system = parse_curve_system("contour", polygon.rows());
    const auto arcs = cut_into_arcs(system, polygon, /*closed=*/true);
    ASSERT_EQ(arcs.size(), expect.at("arcs").size());
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      EXPECT_EQ(arcs[i], exact_matrix(expect.at("arcs")[i]));
      const auto goldman = goldman_maps(system.set, arcs[i]);
      EXPECT_EQ(goldman.has_value(), !expect.at("M_L")[i].is_null());
      if (goldman) {
        EXPECT_EQ(goldman->maps[0], exact_matrix(expect.at("M_L")[i]));
      }
    }
    for (int depth = 0; depth <= 2; ++depth) {
      const auto expected = exact_matrix(expect.at("points_" + std::to_string(depth)));
      int row = 0;
      for (const auto& arc : arcs) {
        const auto points = Ifs<Rational>(system.set, arc).points(depth);
        for (int i = 0; i < points.rows(); ++i, ++row)
          for (int c = 0; c < 2; ++c) EXPECT_EQ(points(i, c), expected(row, c)) << record.at("id");
      }
      EXPECT_EQ(row, polygon.rows() << depth);
    }
  }
}

TEST(fractal_curve_system, cuts_polygons_as_it_says) {
  EXPECT_EQ(parse_curve_system("bezier", 5).text, "bezier:degree=4");
  const CurveSystem chain = parse_curve_system("bezier:degree=3", 7);
  EXPECT_EQ(arc_count(chain, 7, false), 2);
  EXPECT_EQ(arc_count(chain, 6, true), 2);
  const auto arcs = cut_into_arcs(chain, test::some_points(6), true);
  for (int c = 0; c < 2; ++c) {
    EXPECT_EQ(arcs[0](3, c), arcs[1](0, c));
    EXPECT_EQ(arcs[1](3, c), arcs[0](0, c));  // the last point of the last arc is the first of all
  }
  const CurveSystem chaikin = parse_curve_system("chaikin", 5);
  EXPECT_EQ(chaikin.text, "chaikin");
  EXPECT_EQ(arc_count(chaikin, 5, false), 3);
  EXPECT_EQ(arc_count(chaikin, 5, true), 5);
  EXPECT_EQ(arc_count(parse_curve_system("natural-spline", 9), 9, false), 8);
}

TEST(fractal_curve_system, refuses_polygons_and_texts_that_do_not_fit) {
  EXPECT_THROW((void)arc_count(parse_curve_system("bezier:degree=3", 6), 6, false), InvalidField);
  EXPECT_THROW((void)arc_count(parse_curve_system("bezier:degree=3", 7), 7, true), InvalidField);
  EXPECT_THROW((void)arc_count(parse_curve_system("chaikin", 2), 2, false), InvalidField);
  EXPECT_THROW((void)arc_count(parse_curve_system("natural-spline", 4), 4, true), InvalidField);
  EXPECT_THROW((void)arc_count(parse_curve_system("natural-spline", 1), 1, false), InvalidField);
  EXPECT_THROW((void)parse_curve_system("bezier", 1), InvalidField);
  EXPECT_THROW((void)parse_curve_system("bezier", 1309), InvalidField);
  EXPECT_THROW((void)contour_arcs(test::some_points(2)), InvalidField);
  for (const char* text : {"bezier:degree=0", "bezier:degree=65", "bezier:degree=x",
                           "bezier:degree=5/2", "bezier:order=3", "no-such-thing"})
    EXPECT_THROW((void)parse_curve_system(text, 4), InvalidScheme) << text;
}

}  // namespace
}  // namespace arete

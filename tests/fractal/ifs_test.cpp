// SPDX-License-Identifier: MIT
// Attractors: oracle records exactly, both forms, both algorithms, and what they do at the edges.
#include "arete/fractal/ifs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "arete/fractal/chaos_game.h"
#include "arete/fractal/contraction.h"
#include "arete/fractal/goldman.h"
#include "arete/fractal/tensor.h"
#include "support.h"

namespace arete {
namespace {

using nlohmann::json;
using test::exact_matrix;
using test::ternary_and_reverse_records;

// p_0 M_{w_k} ... M_{w_1} for all addresses in the order of the curve: Goldman's form, literally.
Matrix<Rational> goldman_points(const GoldmanMaps& goldman, int depth, int dimension) {
  const int arity = static_cast<int>(goldman.maps.size());
  int count = 1;
  for (int i = 0; i < depth; ++i) count *= arity;
  Matrix<Rational> points(count, dimension);
  for (int number = 0; number < count; ++number) {
    Matrix<Rational> point(1, goldman.padded.cols());
    for (int c = 0; c < point.cols(); ++c) point(0, c) = goldman.padded(0, c);
    int digits = number;  // the last digit of the address is applied first
    for (int i = 0; i < depth; ++i, digits /= arity)
      point = point * goldman.maps[static_cast<std::size_t>(digits % arity)];
    for (int c = 0; c < dimension; ++c) points(number, c) = point(0, c);
  }
  return points;
}

TEST(fractal_ifs, goldman_maps_of_the_records) {
  for (const json& record : ternary_and_reverse_records("r.ifs")) {
    const auto goldman = goldman_maps(test::named_pair(record.at("input").at("scheme")),
                                      exact_matrix(record.at("input").at("control")));
    ASSERT_TRUE(goldman.has_value());
    EXPECT_EQ(goldman->padding, 0);
    EXPECT_EQ(goldman->maps[0], exact_matrix(record.at("expect").at("M_L"))) << record.at("id");
    EXPECT_EQ(goldman->maps[1], exact_matrix(record.at("expect").at("M_R"))) << record.at("id");
  }
}

TEST(fractal_ifs, attractors_of_the_records_in_both_forms) {
  for (const json& record : ternary_and_reverse_records("r.attractor")) {
    const MatrixSet<Rational> pair = test::named_pair(record.at("input").at("scheme"));
    const auto control = exact_matrix(record.at("input").at("control"));
    const int depth = record.at("input").at("depth");
    const auto expected = exact_matrix(record.at("expect").at("points"));
    EXPECT_EQ(Ifs<Rational>(pair, control).points(depth), expected) << record.at("id");
    EXPECT_EQ(goldman_points(goldman_maps(pair, control).value(), depth, 2), expected);
  }
}

TEST(fractal_ifs, higher_degrees_are_padded_and_the_padding_does_not_matter) {
  for (const json& record : ternary_and_reverse_records("r.pad")) {
    const json& input = record.at("input");
    const MatrixSet<Rational> pair = bezier_pair<Rational>(input.at("degree").get<int>());
    const auto control = exact_matrix(input.at("control"));
    const int depth = input.at("depth");
    const auto expected = exact_matrix(record.at("expect").at("points"));
    const auto goldman = goldman_maps(pair, control);
    ASSERT_TRUE(goldman.has_value()) << record.at("id");
    EXPECT_EQ(goldman->padding, record.at("expect").at("columns_beyond_xy1").get<int>());
    EXPECT_EQ(goldman->padded.cols(), control.rows());
    EXPECT_EQ(goldman_points(*goldman, depth, 2), expected) << record.at("id");
    EXPECT_EQ(Ifs<Rational>(pair, control).points(depth), expected);
    // P M_A = A P, and the column of the coordinate 1 stays.
    for (int d = 0; d < 2; ++d) {
      const Matrix<Rational>& map = goldman->maps[static_cast<std::size_t>(d)];
      EXPECT_EQ(goldman->padded * map, pair[d] * goldman->padded);
      for (int i = 0; i < map.rows(); ++i) EXPECT_EQ(map(i, 2), Rational(i == 2 ? 1 : 0));
    }
  }
}

TEST(fractal_ifs, a_patch_of_k_squared_points_needs_k_squared_minus_4_columns) {
  for (int k : {3, 4}) {
    const MatrixSet<Rational> pair = bezier_pair<Rational>(k - 1);
    const auto patch = tensor_product(pair, pair);
    Matrix<Rational> net(k * k, 3);
    for (int i = 0; i < k * k; ++i) {
      net(i, 0) = i / k;
      net(i, 1) = i % k;
      net(i, 2) = Rational((5 * i * i + i) % 7, 2);
    }
    const auto goldman = goldman_maps(patch, net);
    ASSERT_TRUE(goldman.has_value());
    EXPECT_EQ(goldman->padding, k * k - 4);
    EXPECT_EQ(goldman_points(*goldman, 2, 3), Ifs<Rational>(patch, net).points(2));
  }
}

TEST(fractal_ifs, points_that_do_not_span_have_no_inverse_but_still_a_curve) {
  const MatrixSet<Rational> pair = bezier_pair<Rational>(2);
  const auto collinear = matrix_of_rows<Rational>({{0, 0}, {1, 1}, {4, 4}});
  const auto repeated = matrix_of_rows<Rational>({{1, 2}, {1, 2}, {1, 2}});
  EXPECT_EQ(goldman_maps(pair, collinear), std::nullopt);
  EXPECT_EQ(goldman_maps(pair, repeated), std::nullopt);
  const auto points = Ifs<Rational>(pair, collinear).points(1);
  EXPECT_EQ(points, matrix_of_rows<Rational>({{0, 0}, {Rational(3, 2), Rational(3, 2)}}));
  const auto same = Ifs<Rational>(pair, repeated).points(2);
  for (int i = 0; i < same.rows(); ++i) EXPECT_EQ(same(i, 1), 2);
  // One point alone is the curve of degree 0, its maps are the identity: legal and constant.
  EXPECT_EQ(Ifs<Rational>(bezier_pair<Rational>(0), matrix_of_rows<Rational>({{5, 6}})).points(1),
            matrix_of_rows<Rational>({{5, 6}, {5, 6}}));
}

TEST(fractal_ifs, refuses_what_does_not_fit) {
  const MatrixSet<Rational> pair = bezier_pair<Rational>(2);
  EXPECT_THROW(Ifs<Rational>(pair, test::some_points(4)), InvalidField);
  EXPECT_THROW((void)goldman_maps(pair, test::some_points(2)), InvalidField);
  const Ifs<Rational> ifs(pair, test::some_points(3));
  EXPECT_THROW((void)ifs.count(-1), InvalidField);
  EXPECT_THROW((void)ifs.count(41), InvalidField);
  EXPECT_EQ(ifs.count(40), 1LL << 40);
  EXPECT_THROW((void)ifs.points(29), InvalidField);
  EXPECT_THROW(ifs.visit_points(1, first_point_seed<Rational>(4), [](const auto&) {}),
               InvalidField);
}

TEST(fractal_ifs, an_arc_is_what_its_address_says) {
  const MatrixSet<Rational> pair = test::named_pair("de_rham");
  const Ifs<Rational> ifs(pair, test::some_points(3));
  EXPECT_EQ(ifs.arc({}), ifs.control());
  EXPECT_EQ(ifs.arc({0, 1, 1}), address_product(pair, {0, 1, 1}) * ifs.control());
  EXPECT_EQ(ifs.arc({0, 1}), pair[1] * (pair[0] * ifs.control()));
  std::vector<Matrix<Rational>> arcs;
  ifs.visit_arcs(2, [&arcs](const Matrix<Rational>& arc) { arcs.push_back(arc); });
  EXPECT_EQ(arcs,
            (std::vector{ifs.arc({0, 0}), ifs.arc({0, 1}), ifs.arc({1, 0}), ifs.arc({1, 1})}));
}

// For Bezier curves the start points are the curve itself at k/2^depth.
TEST(fractal_ifs, bezier_points_are_the_curve_at_dyadic_parameters) {
  const auto control = test::some_points(4);
  const auto points = Ifs<Rational>(bezier_pair<Rational>(3), control).points(4);
  for (int k = 0; k < 16; ++k) {
    const Rational t(k, 16);
    const Rational s = 1 - t;
    for (int c = 0; c < 2; ++c)
      EXPECT_EQ(points(k, c), s * s * s * control(0, c) + 3 * s * s * t * control(1, c) +
                                  3 * s * t * t * control(2, c) + t * t * t * control(3, c));
  }
}

struct Cloud {
  std::vector<std::array<double, 2>> points;

  [[nodiscard]] double distance_to(const std::array<double, 2>& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& q : points) least = std::min(least, std::hypot(q[0] - p[0], q[1] - p[1]));
    return least;
  }
};

double hausdorff(const Cloud& a, const Cloud& b) {
  double largest = 0;
  for (const auto& p : a.points) largest = std::max(largest, b.distance_to(p));
  for (const auto& p : b.points) largest = std::max(largest, a.distance_to(p));
  return largest;
}

double diameter(const Matrix<double>& points) {
  double largest = 0;
  for (int i = 0; i < points.rows(); ++i)
    for (int j = 0; j < i; ++j)
      largest =
          std::max(largest, std::hypot(points(i, 0) - points(j, 0), points(i, 1) - points(j, 1)));
  return largest;
}

Cloud attractor(const Ifs<double>& ifs, int depth, const Matrix<double>& seeds) {
  Cloud cloud;
  ifs.visit_points(depth, seeds, [&cloud](const std::vector<double>& p) {
    cloud.points.push_back({p[0], p[1]});
  });
  return cloud;
}

// The attractor does not depend on the starting set: the Hausdorff distance of two pictures obeys
// the bound of contraction.h, and the bound tends to 0.
TEST(fractal_ifs, the_attractor_is_independent_of_the_starting_set) {
  for (const MatrixPair<Rational>& pair : {test::named_pair("de_rham"), test::named_pair("bezier3"),
                                           perturbed_bezier_pair<Rational>()}) {
    const MatrixSet<Rational> set = pair;
    const auto contraction = find_contraction(set);
    ASSERT_TRUE(contraction.has_value());
    const double rate = to_double(contraction->coefficient);
    ASSERT_LT(rate, 1);
    const Ifs<double> ifs(to_double(set), to_double(test::some_points(set.size())));
    Matrix<double> first = first_point_seed<double>(set.size());
    // A far point outside the polygon: b = 4 e_last - 3 e_first.
    Matrix<double> far(1, set.size());
    far(0, set.size() - 1) = 4;
    far(0, 0) = -3;
    const double length = 8;  // |first - far|_1
    double bound = 0;
    for (int depth : {0, 2, 4, 6, 8, 10}) {
      bound = 0.5 * length * to_double(contraction->shorter) *
              std::pow(rate, depth / contraction->power) * diameter(ifs.control());
      EXPECT_LE(hausdorff(attractor(ifs, depth, first), attractor(ifs, depth, far)),
                bound * (1 + 1e-12))
          << depth;
    }
    EXPECT_LT(bound, 0.6 * 0.5 * length * diameter(ifs.control()));
  }
}

TEST(fractal_ifs, the_printed_perturbed_pair_and_a_rotation_do_not_contract) {
  // Swapping the points of a segment for ever: rows sum to 1, nothing shrinks.
  const auto swap = matrix_of_rows<Rational>({{0, 1}, {1, 0}});
  EXPECT_EQ(find_contraction(MatrixSet<Rational>{{swap, swap}}, 4), std::nullopt);
}

TEST(fractal_chaos_game, is_reproducible_and_stays_at_the_attractor) {
  const MatrixSet<double> set = to_double(MatrixSet<Rational>(perturbed_bezier_pair<Rational>()));
  const Matrix<double> control =
      to_double(matrix_of_rows<Rational>({{0, 0}, {1, 3}, {3, 3}, {4, 0}}));
  ChaosGame one(set, {control}, 7);
  ChaosGame same(set, {control}, 7);
  ChaosGame other(set, {control}, 8);
  const Ifs<double> ifs(set, control);
  const Cloud curve = attractor(ifs, 12, first_point_seed<double>(4));
  Cloud played;
  bool differs = false;
  for (int i = 0; i < 2000; ++i) {
    const std::vector<double> point = one.next();
    ASSERT_EQ(point, same.next());
    differs = differs || point != other.next();
    played.points.push_back({point[0], point[1]});
    // The diameters of arcs shrink as 0.74^depth.
    EXPECT_LT(curve.distance_to({point[0], point[1]}), 5 * std::pow(0.74, 12));
  }
  EXPECT_TRUE(differs);
  // And it visits all of it: every arc of depth 4 has a point near.
  for (const auto& p : attractor(ifs, 4, first_point_seed<double>(4)).points)
    EXPECT_LT(played.distance_to(p), 0.2);
}

TEST(fractal_chaos_game, draws_all_arcs_of_a_curve) {
  const MatrixSet<double> set = to_double(MatrixSet<Rational>(bezier_pair<Rational>(1)));
  std::vector<Matrix<double>> arcs;
  for (double x : {0.0, 10.0, 20.0}) {
    Matrix<double> arc(2, 1);
    arc(0, 0) = x;
    arc(1, 0) = x + 1;
    arcs.push_back(arc);
  }
  ChaosGame game(set, arcs, 1);
  std::array<int, 3> visits{};
  for (int i = 0; i < 3000; ++i) {
    const double x = game.next()[0];
    const auto arc = static_cast<std::size_t>(x / 10);
    EXPECT_LE(x - 10 * static_cast<double>(arc), 1);
    ++visits.at(arc);
  }
  for (const int count : visits) EXPECT_NEAR(count, 1000, 130);  // five standard deviations
  EXPECT_THROW(ChaosGame(set, {}, 1), InvalidField);
}

}  // namespace
}  // namespace arete

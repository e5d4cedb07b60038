// SPDX-License-Identifier: MIT
// Control points whose limit passes through data: for every scheme that can, and why others cannot.
#include "arete/variational/cardinal.h"

#include <gtest/gtest.h>

#include <cmath>

#include "arete/analysis/limit_stencil.h"
#include "arete/fractal/arc_matrices.h"
#include "arete/refine/reference.h"
#include "arete/refine/refiner.h"
#include "arete/variational/cardinal_source.h"
#include "arete/variational/natural_spline.h"
#include "support/fields.h"
#include "support/schemes.h"
#ifdef ARETE_HAVE_GDAL
#include "arete/gdal/band_source.h"
#include "support/source_dir.h"
#endif

namespace arete {
namespace {

using Rationals = std::vector<Rational>;

// The weights of the limit at the position of a sample.
Stencil at_sample(const Mask& mask) {
  return limit_stencil_at(mask, mask.tau() / (mask.arity() - 1)).value();
}

Rationals some_values(int n) {
  Rationals values;
  for (int i = 0; i < n; ++i) values.emplace_back((7 * i * i + 5 * i) % 13 - 6, i % 2 + 1);
  return values;
}

Rational limit_at(const Stencil& limit, const Rationals& control, Boundary boundary, Index i) {
  Rational sum = 0;
  for (std::size_t k = 0; k < limit.weights.size(); ++k)
    sum += limit.weights[k] *
           continued_value(control, boundary, i + limit.first + static_cast<Index>(k));
  return sum;
}

TEST(cardinal, the_limit_of_every_scheme_passes_through_the_data_exactly) {
  int solved = 0;
  for (const Scheme& scheme : test::sample_schemes()) {
    if (!limit_stencil(scheme.mask())) continue;
    const auto at =
        limit_stencil_at(scheme.mask(), scheme.mask().tau() / (scheme.mask().arity() - 1));
    if (!at) continue;
    for (const Boundary boundary :
         {Boundary::extrapolate, Boundary::clamp, Boundary::reflect, Boundary::periodic})
      for (const int count : {1, 2, 3, 4, 9, 14}) {
        SCOPED_TRACE(scheme.text() + " " + std::string(to_string(boundary)) + " " +
                     std::to_string(count));
        const Rationals values = some_values(count);
        Rationals control = values;
        try {
          CardinalAxis<Rational>(*at, boundary, count).solve(control.data());
        } catch (const InvalidField& error) {
          ADD_FAILURE() << error.what();
          continue;
        }
        for (Index i = 0; i < count; ++i)
          ASSERT_EQ(limit_at(*at, control, boundary, i), values[static_cast<std::size_t>(i)]);
        ++solved;
      }
  }
  EXPECT_GT(solved, 400);
}

TEST(cardinal, of_an_interpolatory_scheme_is_the_data_themselves) {
  for (const char* name : {"four-point", "three-point", "ternary-two-step-9", "dubuc-deslauriers"})
    EXPECT_TRUE(
        CardinalAxis<double>(at_sample(parse_scheme(name).mask()), Boundary::none, 5).trivial())
        << name;
}

// With extrapolated ends the cubic B-spline is the natural spline, C^-1 v.
TEST(cardinal, of_the_cubic_spline_is_the_natural_spline) {
  const Stencil limit = at_sample(parse_scheme("b-spline:degree=3").mask());
  for (int n : {2, 3, 8}) {
    Rationals control = some_values(n);
    Matrix<Rational> points(n, 1);
    for (int i = 0; i < n; ++i) points(i, 0) = control[static_cast<std::size_t>(i)];
    for (const bool closed : {false, true}) {
      Rationals own = control;
      CardinalAxis<Rational>(limit, closed ? Boundary::periodic : Boundary::extrapolate, n)
          .solve(own.data());
      const NaturalSpline<Rational> spline(points,
                                           closed ? SplineEnds::closed : SplineEnds::natural);
      for (int i = 0; i < n; ++i)
        EXPECT_EQ(own[static_cast<std::size_t>(i)], spline.control()(i, 0)) << n << closed;
    }
  }
}

std::string refusal(const Stencil& limit, Boundary boundary, Index count) {
  try {
    const CardinalAxis<double> axis(limit, boundary, count);
  } catch (const InvalidField& error) {
    return error.what();
  }
  return "";
}

TEST(cardinal, is_refused_with_the_reason_where_it_is_singular) {
  // 1/4, 1/2, 1/4 is blind to +1, -1, +1, ...: a mean of two hats, a legal convergent scheme.
  const Mask blind = parse_scheme("mask:arity=2,first=0,coefficients=1/2;1/2;1/2;1/2").mask();
  ASSERT_TRUE(limit_stencil(blind).has_value());
  const std::string reason = refusal(at_sample(blind), Boundary::extrapolate, 20);
  EXPECT_NE(reason.find("period of 2.00 samples have limit 0"), std::string::npos) << reason;
  EXPECT_NE(refusal({0, {Rational(1, 3), Rational(1, 3), Rational(1, 3)}}, Boundary::clamp, 20)
                .find("period of 3.00 samples"),
            std::string::npos);
  const Stencil cubic = at_sample(parse_scheme("b-spline").mask());
  EXPECT_NE(refusal(cubic, Boundary::none, 20).find("boundary none"), std::string::npos);
  EXPECT_NE(refusal(cubic, Boundary::clamp, 0).find("at least one sample"), std::string::npos);
  EXPECT_NE(refusal({0, {}}, Boundary::clamp, 5), "");
  // The weights 1, 3 have no zero on the circle, but solved from the wrong end they blow up.
  EXPECT_NE(refusal({0, {Rational(1, 4), Rational(3, 4)}}, Boundary::clamp, 60).find("magnified"),
            std::string::npos);
  EXPECT_THROW((void)cardinal_control<double>(test::random_heights({3, 3}).view(), cubic, cubic,
                                              {Boundary::none, Boundary::clamp}),
               InvalidField);
}

TEST(cardinal, refuses_missing_samples_and_says_which) {
  const Stencil cubic = at_sample(parse_scheme("b-spline").mask());
  Grid<double> samples = test::random_heights({6, 5});
  samples(4, 3) = std::nan("");
  try {
    (void)cardinal_control<double>(samples.view(), cubic, cubic, {});
    FAIL();
  } catch (const InvalidField& error) {
    EXPECT_NE(std::string(error.what()).find("row 4, column 3"), std::string::npos) << error.what();
  }
}

TEST(cardinal, reach_of_the_cubic_spline_is_28_samples_in_double) {
  const Stencil cubic = at_sample(parse_scheme("b-spline").mask());
  const double rate = 2 - std::sqrt(3.0);
  const Index reach = cardinal_reach(cubic);
  EXPECT_NEAR(static_cast<double>(reach), -53 * std::log(2.0) / std::log(rate), 2);
  EXPECT_LT(cardinal_reach(cubic, 1e-3), 8);
  EXPECT_EQ(cardinal_reach({0, {Rational(1)}}), 0);
}

// An independent interpolating spline: second derivatives at the knots by the textbook tridiagonal
// system (Thomas), cubic pieces between them.
class TextbookSpline {
 public:
  explicit TextbookSpline(std::vector<double> v) : v_(std::move(v)), m_(v_.size(), 0) {
    const std::size_t n = v_.size();
    std::vector<double> ratio(n, 0), right(n, 0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double pivot = 4 - ratio[i - 1];
      ratio[i] = 1 / pivot;
      right[i] = (6 * (v_[i - 1] - 2 * v_[i] + v_[i + 1]) - right[i - 1]) / pivot;
    }
    for (std::size_t i = n - 2; i > 0; --i) m_[i] = right[i] - ratio[i] * m_[i + 1];
  }
  [[nodiscard]] double operator()(double x) const {
    const auto i = std::min(static_cast<std::size_t>(x), v_.size() - 2);
    const double t = x - static_cast<double>(i), s = 1 - t;
    return s * v_[i] + t * v_[i + 1] + ((s * s * s - s) * m_[i] + (t * t * t - t) * m_[i + 1]) / 6;
  }

 private:
  std::vector<double> v_;
  std::vector<double> m_;
};

// Rows first, then columns, at spacing 1/2^levels.
Grid<double> textbook_surface(const Grid<double>& samples, int levels) {
  const Index scale = Index{1} << levels;
  Grid<double> wide({samples.rows(), (samples.cols() - 1) * scale + 1});
  for (Index r = 0; r < samples.rows(); ++r) {
    const TextbookSpline spline({samples.row(r), samples.row(r) + samples.cols()});
    for (Index c = 0; c < wide.cols(); ++c)
      wide(r, c) = spline(static_cast<double>(c) / static_cast<double>(scale));
  }
  Grid<double> result({(samples.rows() - 1) * scale + 1, wide.cols()});
  for (Index c = 0; c < wide.cols(); ++c) {
    std::vector<double> column;
    for (Index r = 0; r < wide.rows(); ++r) column.push_back(wide(r, c));
    const TextbookSpline spline(std::move(column));
    for (Index r = 0; r < result.rows(); ++r)
      result(r, c) = spline(static_cast<double>(r) / static_cast<double>(scale));
  }
  return result;
}

double largest_difference(const Grid<double>& a, const Grid<double>& b) {
  EXPECT_EQ(a.extent(), b.extent());
  double largest = 0;
  for (std::size_t i = 0; i < a.samples().size(); ++i)
    largest = std::max(largest, std::abs(a.samples()[i] - b.samples()[i]));
  return largest;
}

Grid<double> cardinal_cubic(const Grid<double>& samples, int levels) {
  const Scheme cubic = parse_scheme("b-spline:degree=3");
  const Stencil limit = limit_stencil(cubic.mask()).value();
  RefineOptions options;
  options.levels = levels;
  options.final_x = options.final_y = limit;
  const Grid<double> control = cardinal_control<double>(samples.view(), limit, limit, {});
  return refine(control, cubic, options);
}

TEST(cardinal, cubic_spline_equals_an_independent_interpolating_spline) {
  const Grid<double> samples = test::random_heights({23, 17});
  EXPECT_LT(largest_difference(cardinal_cubic(samples, 3), textbook_surface(samples, 3)), 1e-10);
}

#ifdef ARETE_HAVE_GDAL
TEST(cardinal, cubic_spline_on_the_dem_equals_an_independent_interpolating_spline) {
  const gdal::Raster dem(arete::test::source_dir() + "/data/jacksboro_srtm3.tif");
  const Grid<double> samples = gdal::read_band<double>(dem, dem.bands().front());
  ASSERT_GT(samples.rows(), 300);
  EXPECT_LT(largest_difference(cardinal_cubic(samples, 2), textbook_surface(samples, 2)), 1e-9);
}
#endif

// Dual and asymmetric schemes too: the limit, evaluated at the samples by deep refinement.
TEST(cardinal, refined_control_points_come_close_to_the_data_at_their_positions) {
  for (const char* text : {"chaikin", "b-spline:degree=4", "gentle", "four-parameter-c2:nu=3/4"}) {
    const Scheme scheme = parse_scheme(text);
    const Stencil at = at_sample(scheme.mask());
    const Index n = 12;
    std::vector<double> values;
    for (Index i = 0; i < n; ++i) values.push_back(std::sin(0.9 * static_cast<double>(i)));
    std::vector<double> control = values;
    CardinalAxis<double>(at, Boundary::extrapolate, n).solve(control.data());
    const int levels = 12;
    const AxisPlan plan(scheme.mask(), n,
                        {levels, Boundary::extrapolate, Alignment::nodes, {}, {}});
    const std::vector<double> fine = refine_reference(plan, control);
    for (Index i = 1; i + 1 < n; ++i) {
      // The new sample nearest to i is at most half a spacing away.
      const double place =
          (static_cast<double>(i) - to_double(plan.first_position())) / to_double(plan.spacing());
      EXPECT_NEAR(fine.at(static_cast<std::size_t>(std::llround(place))),
                  values[static_cast<std::size_t>(i)], 2e-3)
          << text << ' ' << i;
    }
  }
}

TEST(cardinal, axes_commute_and_streams_equal_the_whole) {
  const Stencil cubic = at_sample(parse_scheme("b-spline").mask());
  const Stencil quintic = at_sample(parse_scheme("b-spline:degree=5").mask());
  const Grid<double> samples = test::random_heights({1000, 9});
  const GridSource<double> source(samples.view());
  for (const Boundary y : {Boundary::extrapolate, Boundary::clamp, Boundary::periodic}) {
    const Boundaries boundaries{Boundary::reflect, y};
    const Grid<double> whole = cardinal_control<double>(samples.view(), quintic, cubic, boundaries);
    const CardinalSource<double> stream(source, quintic, cubic, boundaries);
    EXPECT_LT(stream.working_bytes(), 9 * 8 * 700.0);
    Grid<double> read(samples.extent());
    for (Index r = 999; r >= 0; --r) stream.read(r, read.row(r));
    EXPECT_LT(largest_difference(read, whole), 1e-11);
    // Asked again in another order: the same bits.
    const CardinalSource<double> again(source, quintic, cubic, boundaries);
    std::vector<double> row(9);
    for (const Index r : {500, 3, 999, 501, 128, 0}) {
      again.read(r, row.data());
      for (Index c = 0; c < 9; ++c) EXPECT_EQ(row[static_cast<std::size_t>(c)], read(r, c));
    }
  }
}

TEST(cardinal, a_short_raster_is_one_block) {
  const Stencil cubic = at_sample(parse_scheme("b-spline").mask());
  const Grid<float> samples = test::random_heights<float>({40, 7});
  const GridSource<float> source(samples.view());
  const CardinalSource<float> stream(source, cubic, cubic, {});
  const Grid<float> whole = cardinal_control<float>(samples.view(), cubic, cubic, {});
  std::vector<float> row(7);
  for (Index r = 0; r < 40; ++r) {
    stream.read(r, row.data());
    for (Index c = 0; c < 7; ++c) EXPECT_EQ(row[static_cast<std::size_t>(c)], whole(r, c));
  }
}

}  // namespace
}  // namespace arete

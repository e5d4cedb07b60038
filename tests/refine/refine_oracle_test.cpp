// SPDX-License-Identifier: MIT
// Every refinement record of the oracle files: exactly through the rational path, to 1e-12 through
// the engine in double.
#include <gtest/gtest.h>

#include "arete/refine/curve.h"
#include "arete/refine/reference.h"
#include "arete/scheme/catalogue.h"
#include "support/oracle.h"

namespace arete {
namespace {

using nlohmann::json;
using Rationals = std::vector<Rational>;

Scheme scheme_of(const json& input) {
  if (input.contains("lambda"))
    return make_scheme("four-parameter", {{"lambda", {test::exact(input.at("lambda"))}},
                                          {"mu", {test::exact(input.at("mu"))}},
                                          {"nu", {test::exact(input.at("nu"))}},
                                          {"omega", {test::exact(input.at("omega"))}}});
  return make_scheme("ternary-two-step", {{"b", {test::exact(input.at("b"))}}});
}

// One row a point; numbers alone are points of one coordinate.
Table<Rational> points_of(const json& points) {
  Table<Rational> table;
  for (const auto& point : points)
    table.push_back(point.is_array() ? test::exact_list(point) : Rationals{test::exact(point)});
  return table;
}

Grid<double> to_double_grid(const Table<Rational>& table) {
  Grid<double> grid({static_cast<Index>(table.size()), static_cast<Index>(table.front().size())});
  for (Index r = 0; r < grid.rows(); ++r)
    for (Index c = 0; c < grid.cols(); ++c)
      grid(r, c) = to_double(table[static_cast<std::size_t>(r)][static_cast<std::size_t>(c)]);
  return grid;
}

// `offset` rows and columns of `actual` before the first of `expected` are left out.
void expect_equal(const Table<Rational>& actual, const Grid<double>& engine,
                  const Table<Rational>& expected, Index row_offset, Index col_offset,
                  const std::string& id) {
  ASSERT_EQ(engine.rows(), static_cast<Index>(actual.size())) << id;
  ASSERT_EQ(engine.cols(), static_cast<Index>(actual.front().size())) << id;
  for (std::size_t r = 0; r < expected.size(); ++r) {
    for (std::size_t c = 0; c < expected[r].size(); ++c) {
      const std::size_t i = r + static_cast<std::size_t>(row_offset);
      const std::size_t j = c + static_cast<std::size_t>(col_offset);
      ASSERT_LT(i, actual.size()) << id;
      ASSERT_LT(j, actual[i].size()) << id;
      EXPECT_EQ(actual[i][j], expected[r][c]) << id << " at " << r << ", " << c;
      const double value = to_double(expected[r][c]);
      EXPECT_NEAR(engine(static_cast<Index>(i), static_cast<Index>(j)), value,
                  1e-12 * std::max(1.0, std::abs(value)))
          << id;
    }
  }
}

void check_curve(const json& record, Boundary boundary, int levels, Index first_index,
                 const Table<Rational>& control) {
  const std::string id = record.at("id");
  const Scheme scheme = scheme_of(record.at("input"));
  const AxisPlan plan(scheme.mask(), static_cast<Index>(control.size()),
                      {levels, boundary, Alignment::nodes, {}, {}});
  Table<Rational> columns = transposed(control);
  for (Rationals& column : columns) column = refine_reference(plan, column);
  const Table<Rational> expected = points_of(record.at("expect").at("points"));
  const Curve<double> curve = refine_curve<double>(
      to_double_grid(control).view(), scheme, {levels, boundary == Boundary::periodic, boundary});
  // The paper's rule counts its mask with the zeros at its ends; ours may start earlier.
  const Index offset = first_index - plan.ranges().back().first;
  ASSERT_GE(offset, 0) << id;
  expect_equal(transposed(columns), curve.points, expected, offset, 0, id);
  const bool trimmed = plan.rules().front().symbol.coefficients().size() == 5;
  EXPECT_TRUE(trimmed || curve.points.rows() == static_cast<Index>(expected.size())) << id;
}

TEST(refine_oracle, four_parameter_open_curves) {
  for (const json& record : test::parametric_records("p0.refine_open")) {
    const json& input = record.at("input");
    const int levels = input.at("levels");
    // The record numbers the points from -2 at both levels; index 0 is the third control point.
    const Index origin = -input.at("first_index").get<Index>();
    const Index first = (origin << levels) + record.at("expect").at("first_index").get<Index>();
    check_curve(record, Boundary::none, levels, first, points_of(input.at("points")));
  }
}

TEST(refine_oracle, four_parameter_closed_curves) {
  for (const json& record : test::parametric_records("p0.refine_closed"))
    check_curve(record, Boundary::periodic, record.at("input").at("levels"), 0,
                points_of(record.at("input").at("points")));
}

TEST(refine_oracle, ternary_open_curves) {
  for (const json& record : test::ternary_and_reverse_records("t.refine_open"))
    check_curve(record, Boundary::none, record.at("input").at("steps"),
                record.at("expect").at("first_index").get<Index>(),
                points_of(record.at("input").at("points")));
}

TEST(refine_oracle, ternary_closed_curves) {
  for (const json& record : test::ternary_and_reverse_records("t.refine_closed"))
    check_curve(record, Boundary::periodic, record.at("input").at("steps"), 0,
                points_of(record.at("input").at("points")));
}

// Ghost points made once at level 0; the record's indices count from p_0.
Table<Rational> with_ghosts(const Table<Rational>& points, Index ghosts, bool quadratic) {
  Rationals line;
  for (const auto& point : points) line.push_back(point.front());
  const auto extend_front = [&] {
    line.insert(line.begin(), quadratic ? Rational(3 * line[0] - 3 * line[1] + line[2])
                                        : Rational(2 * line[0] - line[1]));
  };
  for (int side = 0; side < 2; ++side) {
    for (Index i = 0; i < ghosts; ++i) extend_front();
    std::reverse(line.begin(), line.end());
  }
  Table<Rational> table;
  for (const Rational& value : line) table.push_back({value});
  return table;
}

TEST(refine_oracle, ternary_curves_extended_once_at_level_0) {
  for (const json& record : test::ternary_and_reverse_records("t.refine_extended")) {
    const json& input = record.at("input");
    const Index ghosts = input.at("ghosts_each_side_at_level_0");
    const int steps = input.at("steps");
    Index scale = 1;
    for (int i = 0; i < steps; ++i) scale *= 3;
    const bool quadratic = input.at("extension") == "quadratic";
    check_curve(record, Boundary::none, steps,
                ghosts * scale + record.at("expect").at("first_index").get<Index>(),
                with_ghosts(points_of(input.at("points")), ghosts, quadratic));
    if (quadratic) continue;
    // Boundary::extrapolate makes the same linear ghosts by itself: all its results appear.
    const Scheme scheme = scheme_of(input);
    Rationals line;
    for (const auto& point : points_of(input.at("points"))) line.push_back(point.front());
    const AxisPlan plan(scheme.mask(), static_cast<Index>(line.size()),
                        {steps, Boundary::extrapolate, Alignment::nodes, {}, {}});
    const Rationals own = refine_reference(plan, line);
    const Rationals expected = test::exact_list(record.at("expect").at("points"));
    const Index offset =
        plan.ranges().back().first - record.at("expect").at("first_index").get<Index>();
    ASSERT_GE(offset, 0);
    for (std::size_t i = 0; i < own.size(); ++i)
      EXPECT_EQ(own[i], expected.at(i + static_cast<std::size_t>(offset)));
  }
}

Index open_size(const char* scheme, Index count, int levels) {
  const AxisOptions options{levels, Boundary::none, Alignment::nodes, {}, {}};
  return AxisPlan(parse_scheme(scheme).mask(), count, options).output_count();
}

TEST(refine_oracle, open_sizes) {
  for (const json& record : test::parametric_records("p0.open_size"))
    EXPECT_EQ(open_size("gentle", record.at("input").at("points"), record.at("input").at("levels")),
              record.at("expect").get<Index>());
  for (const json& record : test::ternary_and_reverse_records("t.open_size")) {
    const Index count = record.at("input").at("n");
    const auto sizes = record.at("expect").at("sizes").get<std::vector<Index>>();
    const auto closed = record.at("expect").at("closed_sizes").get<std::vector<Index>>();
    for (std::size_t level = 0; level < sizes.size(); ++level)
      EXPECT_EQ(open_size("ternary-two-step", count, static_cast<int>(level)), sizes[level]);
    for (std::size_t level = 0; level < closed.size(); ++level)
      EXPECT_EQ(AxisPlan(parse_scheme("ternary-two-step").mask(), count,
                         {static_cast<int>(level), Boundary::periodic, Alignment::nodes, {}, {}})
                    .output_count(),
                closed[level]);
  }
}

void check_grid(const json& record, Boundaries boundaries, int levels, Index paper_first,
                const Table<Rational>& expected) {
  const std::string id = record.at("id");
  const Scheme scheme = scheme_of(record.at("input"));
  const Table<Rational> grid = points_of(record.at("input").at("grid"));
  const auto plan = [&](Boundary boundary, std::size_t count) {
    return AxisPlan(scheme.mask(), static_cast<Index>(count),
                    {levels, boundary, Alignment::nodes, {}, {}});
  };
  const AxisPlan x = plan(boundaries.x, grid.front().size());
  const AxisPlan y = plan(boundaries.y, grid.size());
  RefineOptions options;
  options.levels = levels;
  options.boundaries = boundaries;
  const auto offset = [&](const AxisPlan& axis) {
    return axis.boundary() == Boundary::periodic ? 0 : paper_first - axis.ranges().back().first;
  };
  expect_equal(refine_reference(x, y, grid), refine(to_double_grid(grid), scheme, options),
               expected, offset(y), offset(x), id);
}

Boundary closed_or_none(const json& closed) {
  return closed.get<bool>() ? Boundary::periodic : Boundary::none;
}

TEST(refine_oracle, four_parameter_tensor_grids) {
  for (const json& record : test::parametric_records("p0.tensor")) {
    const json& input = record.at("input");
    const json& expect = record.at("expect");
    const int levels = input.at("levels");
    // Per level the first computable index of the 7-coefficient mask is 2 (from index 0).
    Index first = 0;
    for (int level = 0; level < levels; ++level) first = 2 * first + 2;
    const Boundaries boundaries{closed_or_none(input.at("closed_cols_direction")),
                                closed_or_none(input.at("closed_rows_direction"))};
    if (expect.contains("grid")) {
      check_grid(record, boundaries, levels, first, points_of(expect.at("grid")));
      continue;
    }
    const Scheme scheme = scheme_of(input);
    const Table<Rational> grid = points_of(input.at("grid"));
    const AxisPlan plan(scheme.mask(), static_cast<Index>(grid.size()),
                        {levels, Boundary::none, Alignment::nodes, {}, {}});
    const Table<Rational> fine = refine_reference(plan, plan, grid);
    ASSERT_EQ(fine.size(), expect.at("rows").get<std::size_t>());
    Rational sum = 0;
    for (const auto& row : fine)
      for (const Rational& value : row) sum += value;
    EXPECT_EQ(sum, test::exact(expect.at("sum")));
    for (const json& at : expect.at("at"))
      EXPECT_EQ(fine[at[0].get<std::size_t>()][at[1].get<std::size_t>()], test::exact(at[2]));
  }
}

TEST(refine_oracle, ternary_tensor_grids) {
  for (const json& record : test::ternary_and_reverse_records("t.grid"))
    check_grid(record,
               {closed_or_none(record.at("input").at("closed_axis1")),
                closed_or_none(record.at("input").at("closed_axis0"))},
               record.at("input").at("steps"), 5, points_of(record.at("expect").at("grid")));
}

}  // namespace
}  // namespace arete

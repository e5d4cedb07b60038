// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/coarsen.h"

#include <gtest/gtest.h>

#include <map>

#include "arete/reverse/grid_reverse.h"
#include "meshlab/grid_mesh.h"
#include "support/schemes.h"

namespace arete::meshlab {
namespace {

using test::grid_mesh;
using test::GridMesh;
using test::MeshForm;

Coarsened run(const MeshArrays& mesh, const Scheme& scheme, const CoarsenOptions& options = {}) {
  Report report;
  return coarsened(mesh, scheme, options, report);
}

RefinedMesh refined(const MeshArrays& mesh, const Scheme& scheme,
                    const SubdivideOptions& options = {}) {
  Report report;
  return subdivided(mesh, scheme, options, report);
}

// Places to a millionth, so that they can be looked up.
using Place = std::pair<long, long>;
Place place_of(const Point3& p) { return {std::lround(p[0] * 1e6), std::lround(p[1] * 1e6)}; }

std::map<Place, double> by_place(const std::vector<Point3>& positions) {
  std::map<Place, double> heights;
  for (const Point3& p : positions) heights[place_of(p)] = p[2];
  return heights;
}

const MeshForm wild{MeshForm::Diagonals::random, true, true, true, 5};

TEST(coarsen, gives_back_what_subdivision_was_made_from) {
  int schemes = 0;
  for (const Scheme& scheme : arete::test::sample_schemes()) {
    const GridMesh mesh = grid_mesh({6, 9}, wild);
    const auto expected = by_place(mesh.arrays.positions);
    for (Boundary boundary : {Boundary::extrapolate, Boundary::clamp, Boundary::reflect}) {
      RefinedMesh fine = refined(mesh.arrays, scheme, {1, boundary});
      Coarsened coarse;
      try {
        coarse = run(fine.arrays, scheme, {1, ReverseMode::least_squares, boundary});
      } catch (const InvalidScheme&) {
        continue;  // the coarse samples are not determined
      }
      ++schemes;
      const auto found = by_place(coarse.mesh.arrays.positions);
      ASSERT_EQ(found.size(), expected.size()) << scheme.text();
      for (const auto& [place, height] : expected) {
        ASSERT_EQ(found.count(place), 1u) << scheme.text() << ' ' << place.first;
        EXPECT_NEAR(found.at(place), height, 1e-8) << scheme.text();
      }
      for (const float detail : coarse.details) EXPECT_NEAR(detail, 0, 1e-6) << scheme.text();
    }
  }
  EXPECT_GE(schemes, 45);
}

TEST(coarsen, refined_again_and_with_its_details_it_is_the_old_terrain) {
  for (const char* text : {"gentle", "b-spline:degree=3", "chaikin", "four-point",
                           "ternary-four-point", "b-spline:degree=5"}) {
    const Scheme scheme = parse_scheme(text);
    const Index m = scheme.mask().arity();
    const Index side = is_integer(scheme.mask().tau()) ? 4 * m + 1 : 4 * m;
    const GridMesh mesh = grid_mesh({side, side + m}, wild);
    for (ReverseMode mode : {ReverseMode::least_squares, ReverseMode::local}) {
      if (mode == ReverseMode::local && local_rule(scheme.mask()) == LocalRule::none) continue;
      const Coarsened coarse = run(mesh.arrays, scheme, {1, mode});
      ASSERT_EQ(coarse.details.size(), mesh.arrays.positions.size());
      const auto again = by_place(refined(coarse.mesh.arrays, scheme).arrays.positions);
      double largest = 0;
      for (std::size_t v = 0; v < coarse.details.size(); ++v) {
        const Point3& p = mesh.arrays.positions[v];
        ASSERT_EQ(again.count(place_of(p)), 1u) << text;
        EXPECT_NEAR(again.at(place_of(p)) + coarse.details[v], p[2], 1e-4) << text;
        largest = std::max(largest, std::abs(double(coarse.details[v])));
      }
      EXPECT_GT(largest, 0.5) << "this terrain has details";
    }
  }
}

TEST(coarsen, heights_equal_the_library_whatever_the_numbering) {
  const Scheme scheme = make_scheme("b-spline");
  const GridMesh plain = grid_mesh({17, 14});
  GridReverseOptions options;
  options.levels = 2;
  const Grid<double> expected =
      decompose_grid<double>(heights_of(plain).view(), scheme, options).coarse;
  for (auto diagonals :
       {MeshForm::Diagonals::main, MeshForm::Diagonals::alternating, MeshForm::Diagonals::random})
    for (bool shuffled : {false, true}) {
      const MeshForm form{diagonals, shuffled, shuffled, shuffled, 3};
      const Coarsened coarse = run(grid_mesh({17, 14}, form).arrays, scheme, {2});
      ASSERT_EQ(coarse.mesh.arrays.positions.size(), expected.samples().size());
      for (Index r = 0; r < expected.rows(); ++r)
        for (Index c = 0; c < expected.cols(); ++c) {
          const auto v = static_cast<std::size_t>(r * expected.cols() + c);
          EXPECT_EQ(coarse.mesh.arrays.positions[v][2], expected(r, c));
        }
    }
}

TEST(coarsen, all_coordinates_come_back_and_details_are_distances) {
  const GridMesh mesh = grid_mesh({5, 6}, wild);
  const Scheme scheme = make_scheme("gentle");
  const RefinedMesh fine =
      refined(mesh.arrays, scheme, {1, Boundary::extrapolate, Coordinates::all});
  const CoarsenOptions all{1, ReverseMode::least_squares, Boundary::extrapolate, Coordinates::all};
  const auto found = by_place(run(fine.arrays, scheme, all).mesh.arrays.positions);
  for (const auto& [place, height] : by_place(mesh.arrays.positions))
    EXPECT_NEAR(found.at(place), height, 1e-8);

  const GridMesh rough = grid_mesh({9, 9}, wild);
  const Coarsened heights = run(rough.arrays, scheme);
  const Coarsened distances = run(rough.arrays, scheme, all);
  for (std::size_t v = 0; v < heights.details.size(); ++v)  // x and y are linear: no details
    EXPECT_NEAR(distances.details[v], std::abs(heights.details[v]), 1e-5);
}

TEST(coarsen, least_squares_misses_less_than_every_second_vertex) {
  const Scheme scheme = make_scheme("four-point");  // its short filters take every second vertex
  const auto missed = [&](ReverseMode mode) {
    double sum = 0;
    for (float d : run(grid_mesh({33, 33}).arrays, scheme, {1, mode}).details) sum += d * d;
    return sum;
  };
  EXPECT_LT(missed(ReverseMode::least_squares), 0.9 * missed(ReverseMode::local));
}

TEST(coarsen, faces_cover_the_terrain_once_and_lie_above_their_sources) {
  for (const char* text : {"four-point", "chaikin", "ternary-four-point"}) {
    for (bool clockwise : {false, true}) {
      const GridMesh mesh =
          grid_mesh({9, 13}, {MeshForm::Diagonals::random, true, true, clockwise, 2});
      const CreatedMesh coarse = run(mesh.arrays, parse_scheme(text)).mesh;
      const double sign = clockwise ? -1 : 1;
      double area = 0;
      std::map<std::pair<int, int>, int> inner;
      for (std::size_t f = 0; f < coarse.arrays.triangles.size(); ++f) {
        const Triangle& t = coarse.arrays.triangles[f];
        const double part = sign * test::area_from_above(coarse.arrays.positions, t);
        EXPECT_GT(part, 0);
        area += part;
        for (std::size_t k = 0; k < 3; ++k)
          if ((coarse.arrays.inner_edges[f] >> k) & 1) ++inner[std::minmax(t[k], t[(k + 1) % 3])];
        std::vector<Point3> points = mesh.arrays.positions;
        Point3 middle{0, 0, 0};
        for (int v : t)
          for (std::size_t k = 0; k < 2; ++k)
            middle[k] += coarse.arrays.positions[std::size_t(v)][k] / 3;
        points.push_back(middle);
        const int m = int(points.size()) - 1;
        const Triangle& s = mesh.arrays.triangles[std::size_t(coarse.source_triangles[f])];
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_GT(sign * test::area_from_above(points, {s[k], s[(k + 1) % 3], m}), -1e-9);
      }
      double west = 1e9, east = -1e9, south = 1e9, north = -1e9;
      for (const Point3& p : coarse.arrays.positions) {
        west = std::min(west, p[0]);
        east = std::max(east, p[0]);
        south = std::min(south, p[1]);
        north = std::max(north, p[1]);
      }
      EXPECT_NEAR(area, (east - west) * (north - south), 1e-6);
      EXPECT_EQ(inner.size() * 2, coarse.arrays.triangles.size());
      for (const auto& [edge, count] : inner) EXPECT_EQ(count, 2) << "a one-sided polygon mark";
    }
  }
}

TEST(coarsen, channels_and_wedges_are_taken_over) {
  for (const char* text : {"four-point", "chaikin", "ternary-four-point"}) {
    GridMesh mesh = grid_mesh({13, 14}, wild);
    Channel linear{{}, Blend::linear}, within{{}, Blend::within}, nearest{{}, Blend::nearest};
    for (const Point3& p : mesh.arrays.positions) {
      linear.values.push_back(float(3 + 0.25 * p[0] - 0.125 * p[1]));
      within.values.push_back(float(p[0]));
      nearest.values.push_back(p[0] > 64 ? 1.F : 0.F);
    }
    mesh.arrays.channels = {linear, within, nearest};
    // Two sheets, the border between them is an edge of the coarse grid or inside its cells.
    for (const Triangle& t : mesh.arrays.triangles) {
      double x = 0;
      for (int v : t) x += mesh.arrays.positions[std::size_t(v)][0] / 3;
      const int sheet = x > 70 ? 1 : 0;
      auto& corners = mesh.arrays.wedges.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& p = mesh.arrays.positions[std::size_t(t[k])];
        corners[k] = {float(p[0] + p[1] / 2 + 1000 * sheet), float(p[1]), sheet};
      }
    }
    const MeshArrays coarse = run(mesh.arrays, parse_scheme(text)).mesh.arrays;
    ASSERT_EQ(coarse.channels.size(), 3u);
    for (std::size_t v = 0; v < coarse.positions.size(); ++v) {
      const Point3& p = coarse.positions[v];
      EXPECT_NEAR(coarse.channels[0].values[v], 3 + 0.25 * p[0] - 0.125 * p[1], 1e-4) << text;
      EXPECT_NEAR(coarse.channels[1].values[v], std::clamp(p[0], 0.0, 130.0), 1e-4) << text;
      if (std::abs(p[0] - 65) > 5.1) {
        EXPECT_EQ(coarse.channels[2].values[v], p[0] > 64 ? 1.F : 0.F) << text;
      }
    }
    ASSERT_EQ(coarse.wedges.size(), coarse.triangles.size());
    for (std::size_t f = 0; f < coarse.triangles.size(); ++f) {
      const int sheet = coarse.wedges[f][0].texture;
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& p = coarse.positions[std::size_t(coarse.triangles[f][k])];
        EXPECT_EQ(coarse.wedges[f][k].texture, sheet) << "one face on two sheets";
        EXPECT_NEAR(coarse.wedges[f][k].u, p[0] + p[1] / 2 + 1000 * sheet, 1e-3) << text;
        EXPECT_NEAR(coarse.wedges[f][k].v, p[1], 1e-3) << text;
      }
    }
  }
}

MeshArrays tube_of(Index around, Index along) {
  MeshArrays tube;
  for (Index r = 0; r < along; ++r)
    for (Index c = 0; c < around; ++c) {
      const double angle = 2 * 3.14159265358979 * double(c) / double(around);
      tube.positions.push_back({std::cos(angle), std::sin(angle), double(r)});
    }
  const auto number = [&](Index r, Index c) { return static_cast<int>(r * around + c % around); };
  for (Index r = 0; r + 1 < along; ++r)
    for (Index c = 0; c < around; ++c) {
      tube.triangles.push_back({number(r, c), number(r, c + 1), number(r + 1, c + 1)});
      tube.triangles.push_back({number(r, c), number(r + 1, c + 1), number(r + 1, c)});
      tube.inner_edges.insert(tube.inner_edges.end(), {4, 1});
    }
  return tube;
}

TEST(coarsen, a_tube_stays_closed) {
  const CoarsenOptions all{1, ReverseMode::least_squares, Boundary::extrapolate, Coordinates::all};
  const MeshArrays tube = tube_of(8, 4);
  const RefinedMesh fine =
      refined(tube, make_scheme("b-spline"), {1, Boundary::extrapolate, Coordinates::all});
  const Coarsened coarse = run(fine.arrays, make_scheme("b-spline"), all);
  EXPECT_EQ(coarse.mesh.arrays.triangles.size(), tube.triangles.size());
  std::map<std::array<long, 3>, int> places;
  const auto key = [](const Point3& p) {
    return std::array{std::lround(p[0] * 1e6), std::lround(p[1] * 1e6), std::lround(p[2] * 1e6)};
  };
  for (const Point3& p : coarse.mesh.arrays.positions) ++places[key(p)];
  for (const Point3& p : tube.positions) EXPECT_EQ(places[key(p)], 1);
}

TEST(coarsen, separate_grids_are_coarsened_one_by_one) {
  const GridMesh one = grid_mesh({5, 7});
  MeshArrays both = one.arrays;
  for (Point3 p : one.arrays.positions) both.positions.push_back({p[0] + 1000, p[1], p[2]});
  both.positions.push_back({-5, -5, -5});  // a loose vertex
  for (Triangle t : one.arrays.triangles)
    both.triangles.push_back({t[0] + 35, t[1] + 35, t[2] + 35});
  const Scheme scheme = make_scheme("gentle");
  const auto alone = by_place(run(one.arrays, scheme).mesh.arrays.positions);
  const Coarsened coarse = run(both, scheme);
  ASSERT_EQ(coarse.mesh.arrays.positions.size(), 2 * alone.size());
  for (const Point3& p : coarse.mesh.arrays.positions) {
    const Point3 moved{p[0] > 500 ? p[0] - 1000 : p[0], p[1], p[2]};
    EXPECT_EQ(alone.at(place_of(moved)), p[2]);
  }
  EXPECT_EQ(coarse.details.size(), both.positions.size());
  EXPECT_EQ(coarse.details.back(), 0);
}

TEST(coarsen, what_cannot_be_coarsened_is_refused_with_the_reason) {
  const auto refusal = [](const MeshArrays& mesh, const char* scheme,
                          const CoarsenOptions& options) {
    try {
      (void)run(mesh, parse_scheme(scheme), options);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what());
    }
    return std::string("not refused");
  };
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  const MeshArrays small = grid_mesh({5, 9}).arrays;
  says(refusal(small, "gentle", {3}), "level 3 would leave 1 x 2; use fewer levels");
  says(refusal(grid_mesh({2, 2}).arrays, "gentle", {1}), "use fewer levels");
  says(refusal(small, "gentle", {1, ReverseMode::local}), "local");
  says(refusal(small, "gentle", {1, ReverseMode::least_squares, Boundary::none}), "boundary");
  says(refusal(small, "gentle", {1, ReverseMode::least_squares, Boundary::periodic}), "periodic");
  says(refusal(tube_of(9, 4), "gentle", {1}), "do not divide by 2");
  says(refusal({}, "gentle", {1}), "empty");
  MeshArrays hole = grid_mesh({6, 6}).arrays;
  hole.triangles.erase(hole.triangles.begin() + 24, hole.triangles.begin() + 26);
  says(refusal(hole, "gentle", {1}), "not a terrain grid");
  MeshArrays infinite = small;
  infinite.positions[7][2] = HUGE_VAL;
  says(refusal(infinite, "gentle", {1}), "vertex 7");
}

}  // namespace
}  // namespace arete::meshlab

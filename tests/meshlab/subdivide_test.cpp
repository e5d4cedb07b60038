// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/subdivide.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "arete/refine/refiner.h"
#include "meshlab/grid_mesh.h"
#include "support/schemes.h"

namespace arete::meshlab {
namespace {

using test::grid_mesh;
using test::GridMesh;
using test::MeshForm;

RefinedMesh run(const MeshArrays& mesh, const Scheme& scheme, const SubdivideOptions& options) {
  Report report;
  return subdivided(mesh, scheme, options, report);
}

// Heights by place: exact only if both sides computed the place the same way.
std::map<std::pair<double, double>, double> by_place(const RefinedMesh& mesh) {
  std::map<std::pair<double, double>, double> heights;
  for (const Point3& p : mesh.arrays.positions) heights[{p[0], p[1]}] = p[2];
  return heights;
}

std::vector<MeshForm> forms() {
  std::vector<MeshForm> result;
  for (auto diagonals : {MeshForm::Diagonals::main, MeshForm::Diagonals::anti,
                         MeshForm::Diagonals::alternating, MeshForm::Diagonals::random})
    for (bool quads : {false, true})
      for (bool shuffled : {false, true})
        result.push_back({diagonals, quads, shuffled, shuffled && quads, 7});
  return result;
}

TEST(subdivide, heights_equal_the_engine_bit_for_bit_whatever_the_numbering) {
  for (const Scheme& scheme : arete::test::sample_schemes()) {
    const int levels = scheme.mask().arity() == 2 ? 2 : 1;
    RefineOptions options;
    options.levels = levels;
    const GridMesh plain = grid_mesh({6, 9});
    const Grid<double> fine = refine(heights_of(plain), scheme, options);
    const Refiner<double> refiner(scheme, plain.extent, options);
    for (const MeshForm& form : forms()) {
      const GridMesh mesh = grid_mesh({6, 9}, form);
      const RefinedMesh result = run(mesh.arrays, scheme, {levels});
      ASSERT_EQ(result.arrays.positions.size(), fine.samples().size()) << scheme.text();
      const auto heights = by_place(result);
      ASSERT_EQ(heights.size(), fine.samples().size()) << scheme.text();
      // Ordered by x, then by y from the south.
      auto entry = heights.begin();
      for (Index c = 0; c < fine.cols(); ++c) {
        for (Index r = fine.rows(); r-- > 0; ++entry) {
          EXPECT_EQ(entry->second, fine(r, c)) << scheme.text();
          const AxisPlacement x = refiner.x().placement();
          const AxisPlacement y = refiner.y().placement();
          EXPECT_NEAR(entry->first.first, 10 * (x.first + double(c) * x.spacing), 1e-9);
          EXPECT_NEAR(entry->first.second, 100 - 20 * (y.first + double(r) * y.spacing), 1e-9);
        }
      }
    }
  }
}

TEST(subdivide, boundaries_equal_the_engine) {
  const Scheme scheme = make_scheme("gentle");
  const GridMesh mesh = grid_mesh({8, 9}, {MeshForm::Diagonals::random, false, true});
  for (Boundary boundary :
       {Boundary::extrapolate, Boundary::clamp, Boundary::reflect, Boundary::none}) {
    RefineOptions options;
    options.boundaries = {boundary, boundary};
    const Grid<double> fine = refine(heights_of(mesh), scheme, options);
    const RefinedMesh result = run(mesh.arrays, scheme, {1, boundary});
    const std::size_t dropped = result.dropped_vertices.size();
    ASSERT_EQ(result.arrays.positions.size() - dropped, fine.samples().size());
    EXPECT_EQ(dropped > 0, boundary == Boundary::none);
    std::multiset<double> heights;
    std::vector<bool> used(result.arrays.positions.size(), true);
    for (int v : result.dropped_vertices) used[static_cast<std::size_t>(v)] = false;
    for (std::size_t v = 0; v < used.size(); ++v)
      if (used[v]) heights.insert(result.arrays.positions[v][2]);
    EXPECT_EQ(heights, std::multiset<double>(fine.samples().begin(), fine.samples().end()));
    for (const Triangle& t : result.arrays.triangles)
      for (int v : t) EXPECT_TRUE(used[static_cast<std::size_t>(v)]);
  }
}

TEST(subdivide, a_periodic_terrain_stays_within_its_rim_and_reads_across_it) {
  const GridMesh mesh = grid_mesh({6, 6});
  RefineOptions options;
  options.boundaries = {Boundary::periodic, Boundary::periodic};
  const Grid<double> fine = refine(heights_of(mesh), make_scheme("b-spline"), options);
  const auto heights = by_place(run(mesh.arrays, make_scheme("b-spline"), {1, Boundary::periodic}));
  ASSERT_EQ(heights.size(), 11u * 11u);
  for (Index r = 0; r < 11; ++r)
    for (Index c = 0; c < 11; ++c)
      EXPECT_EQ(heights.at({5.0 * double(c), 100 - 10.0 * double(r)}), fine(r, c));
  EXPECT_THROW(
      (void)run(mesh.arrays, make_scheme("b-spline"), {1, Boundary::periodic, Coordinates::all}),
      InvalidField);
}

TEST(subdivide, all_coordinates_are_three_height_fields) {
  const GridMesh mesh = grid_mesh({7, 5}, {MeshForm::Diagonals::random, true, true});
  const Scheme scheme = make_scheme("craggy");
  const RefinedMesh result = run(mesh.arrays, scheme, {2, Boundary::reflect, Coordinates::all});
  RefineOptions options;
  options.levels = 2;
  options.boundaries = {Boundary::reflect, Boundary::reflect};
  std::multiset<Point3> expected;
  std::array<Grid<double>, 3> planes;
  for (std::size_t k = 0; k < 3; ++k) {
    Grid<double> plane(mesh.extent);
    for (Index r = 0; r < 7; ++r)
      for (Index c = 0; c < 5; ++c)
        plane(r, c) = mesh.arrays.positions[static_cast<std::size_t>(mesh.vertex(r, c))][k];
    planes[k] = refine(plane, scheme, options);
  }
  for (std::size_t i = 0; i < planes[0].samples().size(); ++i)
    expected.insert({planes[0].samples()[i], planes[1].samples()[i], planes[2].samples()[i]});
  EXPECT_EQ(std::multiset<Point3>(result.arrays.positions.begin(), result.arrays.positions.end()),
            expected);
}

TEST(subdivide, detail_equals_the_engine_and_moves_heights_only) {
  Detail detail;
  detail.seed = 7;
  detail.relief = 0.2;
  for (const char* text : {"gentle", "four-point", "chaikin", "ternary-four-point"}) {
    const Scheme scheme = parse_scheme(text);
    RefineOptions options;
    options.levels = 2;
    options.detail = detail;
    const Grid<double> fine = refine(heights_of(grid_mesh({6, 9})), scheme, options);
    for (const MeshForm& form : forms()) {
      const GridMesh mesh = grid_mesh({6, 9}, form);
      SubdivideOptions with{2};
      const auto smooth = by_place(run(mesh.arrays, scheme, with));
      with.detail = detail;
      const auto heights = by_place(run(mesh.arrays, scheme, with));
      ASSERT_EQ(heights.size(), smooth.size());
      auto entry = heights.begin();
      auto other = smooth.begin();
      for (Index c = 0; c < fine.cols(); ++c)
        for (Index r = fine.rows(); r-- > 0; ++entry, ++other) {
          EXPECT_EQ(entry->second, fine(r, c)) << text;
          EXPECT_EQ(entry->first, other->first) << "a vertex moved in plan";
        }
      EXPECT_NE(heights, smooth);
      with.detail->seed = 8;
      EXPECT_NE(by_place(run(mesh.arrays, scheme, with)), heights);
      with.detail->relief = 0;
      EXPECT_EQ(by_place(run(mesh.arrays, scheme, with)), smooth);
    }
  }
}

TEST(subdivide, detail_moves_only_z_when_all_coordinates_are_refined) {
  const GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, true, true});
  SubdivideOptions options{2, Boundary::extrapolate, Coordinates::all};
  const auto smooth = run(mesh.arrays, make_scheme("gentle"), options).arrays.positions;
  options.detail.emplace();
  const auto rough = run(mesh.arrays, make_scheme("gentle"), options).arrays.positions;
  int moved = 0;
  for (std::size_t v = 0; v < smooth.size(); ++v) {
    EXPECT_EQ(rough[v][0], smooth[v][0]);
    EXPECT_EQ(rough[v][1], smooth[v][1]);
    if (rough[v][2] != smooth[v][2]) ++moved;
  }
  EXPECT_GT(moved, int(smooth.size()) / 2);
}

TEST(subdivide, old_vertices_keep_their_numbers) {
  const GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, true, true});
  const RefinedMesh kept = run(mesh.arrays, make_scheme("four-point"), {2});
  for (std::size_t v = 0; v < mesh.arrays.positions.size(); ++v)
    EXPECT_EQ(kept.arrays.positions[v], mesh.arrays.positions[v]);
  // A dual scheme has no sample there: the nearest within half a cell takes over.
  const RefinedMesh dual = run(mesh.arrays, make_scheme("chaikin"), {1});
  for (std::size_t v = 0; v < mesh.arrays.positions.size(); ++v) {
    EXPECT_LE(std::abs(dual.arrays.positions[v][0] - mesh.arrays.positions[v][0]),
              10 * 0.25 + 1e-9);
    EXPECT_LE(std::abs(dual.arrays.positions[v][1] - mesh.arrays.positions[v][1]),
              20 * 0.25 + 1e-9);
  }
}

TEST(subdivide, faces_cover_the_terrain_once_and_look_to_the_old_side) {
  for (const Scheme& scheme : arete::test::sample_schemes()) {
    for (bool clockwise : {false, true}) {
      MeshForm form{MeshForm::Diagonals::random, true, true, clockwise};
      const GridMesh mesh = grid_mesh({5, 6}, form);
      const RefinedMesh result = run(mesh.arrays, scheme, {1});
      const double sign = clockwise ? -1 : 1;
      double area = 0;
      std::map<std::pair<int, int>, int> inner;
      for (std::size_t f = 0; f < result.arrays.triangles.size(); ++f) {
        const Triangle& t = result.arrays.triangles[f];
        const double part = sign * test::area_from_above(result.arrays.positions, t);
        EXPECT_GT(part, 0) << scheme.text();
        area += part;
        for (std::size_t k = 0; k < 3; ++k)
          if ((result.arrays.inner_edges[f] >> k) & 1) ++inner[std::minmax(t[k], t[(k + 1) % 3])];
      }
      const auto x =
          std::minmax_element(result.arrays.positions.begin(), result.arrays.positions.end());
      double south = 1e9, north = -1e9;
      for (const Point3& p : result.arrays.positions) {
        south = std::min(south, p[1]);
        north = std::max(north, p[1]);
      }
      EXPECT_NEAR(area, ((*x.second)[0] - (*x.first)[0]) * (north - south), 1e-6) << scheme.text();
      EXPECT_EQ(inner.size() * 2, result.arrays.triangles.size());
      for (const auto& [edge, count] : inner) EXPECT_EQ(count, 2) << "a one-sided polygon mark";
    }
  }
}

TEST(subdivide, can_be_repeated) {
  const GridMesh mesh = grid_mesh({5, 4}, {MeshForm::Diagonals::random, true, true});
  const Scheme scheme = make_scheme("gentle");
  const auto once = run(run(mesh.arrays, scheme, {1}).arrays, scheme, {1});
  const auto twice = run(mesh.arrays, scheme, {2});
  const auto a = by_place(once);
  const auto b = by_place(twice);
  ASSERT_EQ(a.size(), b.size());
  // Ghosts are made anew at each run, so the rim may differ; the inside must not.
  for (const auto& [place, height] : a)
    if (place.first >= 10 && place.first <= 20 && place.second == 40) {
      EXPECT_NEAR(height, b.at(place), 1e-9);
    }
}

TEST(subdivide, channels_are_linear_and_exact_at_old_vertices) {
  GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, false, true});
  Channel linear;
  Channel texture{{}, Blend::nearest};
  for (const Point3& p : mesh.arrays.positions) {
    linear.values.push_back(static_cast<float>(3 + 0.25 * p[0] - 0.125 * p[1]));
    texture.values.push_back(p[0] > 25 ? 1.F : 0.F);
  }
  mesh.arrays.channels = {linear, texture};
  for (const Scheme& scheme : arete::test::sample_schemes()) {
    const RefinedMesh result = run(mesh.arrays, scheme, {1});
    for (std::size_t v = 0; v < result.arrays.positions.size(); ++v) {
      const Point3& p = result.arrays.positions[v];
      EXPECT_NEAR(result.arrays.channels[0].values[v], 3 + 0.25 * p[0] - 0.125 * p[1], 1e-5);
      if (std::abs(p[0] - 25) > 1e-6) {
        EXPECT_EQ(result.arrays.channels[1].values[v], p[0] > 25 ? 1.F : 0.F) << scheme.text();
      }
    }
  }
}

// Wedges that are one linear function everywhere but for a seam: beyond it u is 100 more.
void add_wedges(MeshArrays& mesh, const std::function<bool(const Triangle&)>& beyond) {
  for (const Triangle& t : mesh.triangles) {
    auto& corners = mesh.wedges.emplace_back();
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3& p = mesh.positions[static_cast<std::size_t>(t[k])];
      const bool other = beyond(t);
      corners[k] = {static_cast<float>(p[0] + p[1] / 2 + (other ? 100 : 0)),
                    static_cast<float>(p[1]), other ? 1 : 0};
    }
  }
}

TEST(subdivide, wedges_are_linear_and_seams_survive) {
  for (const Scheme& scheme : {make_scheme("four-point"), make_scheme("chaikin"),
                               make_scheme("ternary-four-point"), make_scheme("gentle")}) {
    GridMesh mesh = grid_mesh({6, 7}, {MeshForm::Diagonals::random, true, true, true});
    const auto centre = [&](const Triangle& t) {
      double x = 0;
      for (int v : t) x += mesh.arrays.positions[static_cast<std::size_t>(v)][0] / 3;
      return x;
    };
    add_wedges(mesh.arrays, [&](const Triangle& t) { return centre(t) > 30; });
    const RefinedMesh result = run(mesh.arrays, scheme, {1});
    ASSERT_EQ(result.arrays.wedges.size(), result.arrays.triangles.size());
    for (std::size_t f = 0; f < result.arrays.triangles.size(); ++f) {
      const bool other = result.arrays.wedges[f][0].texture == 1;
      EXPECT_EQ(
          other,
          centre(mesh.arrays.triangles[static_cast<std::size_t>(result.source_triangles[f])]) > 30);
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3& p =
            result.arrays.positions[static_cast<std::size_t>(result.arrays.triangles[f][k])];
        const WedgeUv& w = result.arrays.wedges[f][k];
        EXPECT_EQ(w.texture == 1, other);
        EXPECT_NEAR(w.u, p[0] + p[1] / 2 + (other ? 100 : 0), 1e-4) << scheme.text();
        EXPECT_NEAR(w.v, p[1], 1e-4) << scheme.text();
      }
    }
  }
}

TEST(subdivide, a_seam_along_diagonals_survives) {
  for (auto diagonals : {MeshForm::Diagonals::main, MeshForm::Diagonals::anti}) {
    for (bool clockwise : {false, true}) {
      GridMesh mesh = grid_mesh({5, 5}, {diagonals, false, false, clockwise});
      // Every second triangle is on another sheet.
      for (std::size_t i = 0; i < mesh.arrays.triangles.size(); ++i) {
        auto& corners = mesh.arrays.wedges.emplace_back();
        for (std::size_t k = 0; k < 3; ++k) {
          const Point3& p =
              mesh.arrays.positions[static_cast<std::size_t>(mesh.arrays.triangles[i][k])];
          const auto sheet = static_cast<int>(i % 2);
          corners[k] = {static_cast<float>(p[0] + 1000 * sheet), static_cast<float>(p[1]), sheet};
        }
      }
      const RefinedMesh result = run(mesh.arrays, make_scheme("four-point"), {2});
      for (std::size_t i = 0; i < result.arrays.triangles.size(); ++i) {
        const int sheet = result.source_triangles[i] % 2;
        for (std::size_t k = 0; k < 3; ++k) {
          const Point3& p =
              result.arrays.positions[static_cast<std::size_t>(result.arrays.triangles[i][k])];
          EXPECT_NEAR(result.arrays.wedges[i][k].u, p[0] + 1000 * sheet, 1e-3);
          EXPECT_NEAR(result.arrays.wedges[i][k].v, p[1], 1e-3);
          EXPECT_EQ(result.arrays.wedges[i][k].texture, sheet);
        }
      }
    }
  }
}

TEST(subdivide, new_triangles_lie_in_their_sources) {
  GridMesh mesh = grid_mesh({5, 6}, {MeshForm::Diagonals::random, false, true});
  const RefinedMesh result = run(mesh.arrays, make_scheme("ternary-four-point"), {1});
  for (std::size_t f = 0; f < result.arrays.triangles.size(); ++f) {
    Point3 middle{0, 0, 0};
    for (int v : result.arrays.triangles[f])
      for (std::size_t k = 0; k < 2; ++k)
        middle[k] += result.arrays.positions[static_cast<std::size_t>(v)][k] / 3;
    const Triangle& s = mesh.arrays.triangles[static_cast<std::size_t>(result.source_triangles[f])];
    std::vector<Point3> p = mesh.arrays.positions;
    p.push_back(middle);
    const int m = static_cast<int>(p.size()) - 1;
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_GT(test::area_from_above(p, {s[k], s[(k + 1) % 3], m}), -1e-9);
  }
}

TEST(subdivide, a_tube_of_quads_is_closed_again) {
  constexpr Index around = 8, along = 4;
  MeshArrays tube;
  for (Index r = 0; r < along; ++r)
    for (Index c = 0; c < around; ++c) {
      const double angle = 2 * 3.14159265358979 * double(c) / around;
      tube.positions.push_back({std::cos(angle), std::sin(angle), double(r)});
    }
  const auto number = [](Index r, Index c) { return static_cast<int>(r * around + c % around); };
  for (Index r = 0; r + 1 < along; ++r)
    for (Index c = 0; c < around; ++c) {
      tube.triangles.push_back({number(r, c), number(r, c + 1), number(r + 1, c + 1)});
      tube.triangles.push_back({number(r, c), number(r + 1, c + 1), number(r + 1, c)});
      tube.inner_edges.insert(tube.inner_edges.end(), {4, 1});
    }
  const RefinedMesh result =
      run(tube, make_scheme("b-spline"), {1, Boundary::extrapolate, Coordinates::all});
  EXPECT_EQ(result.arrays.positions.size(), 16u * 7u);
  EXPECT_EQ(result.arrays.triangles.size(), 16u * 6u * 2u);
  std::map<std::pair<int, int>, int> edges;
  for (const Triangle& t : result.arrays.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++edges[std::minmax(t[k], t[(k + 1) % 3])];
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const auto& e) { return e.second == 1; }),
            32);  // the two ends
  // All new vertices around lie on two circles: on old angles and between.
  std::set<long> radii;
  for (const Point3& p : result.arrays.positions)
    radii.insert(std::lround(1e9 * std::hypot(p[0], p[1])));
  EXPECT_EQ(radii.size(), 2u);
}

TEST(subdivide, separate_grids_are_refined_one_by_one) {
  GridMesh one = grid_mesh({4, 5});
  const GridMesh other = grid_mesh({3, 6}, {}, [](Index r, Index c) { return double(r * c); });
  MeshArrays both = one.arrays;
  for (Point3 p : other.arrays.positions) {
    p[0] += 1000;
    both.positions.push_back(p);
  }
  both.positions.push_back({-5, -5, -5});  // a loose vertex
  for (Triangle t : other.arrays.triangles) {
    for (int& v : t) v += 20;
    both.triangles.push_back(t);
  }
  const Scheme scheme = make_scheme("gentle");
  const auto a = by_place(run(one.arrays, scheme, {2}));
  const auto b = by_place(run(other.arrays, scheme, {2}));
  const RefinedMesh result = run(both, scheme, {2});
  EXPECT_EQ(result.arrays.positions[38], (Point3{-5, -5, -5}));
  ASSERT_EQ(result.arrays.positions.size(), a.size() + b.size() + 1);
  for (std::size_t v = 0; v < result.arrays.positions.size(); ++v) {
    const Point3& p = result.arrays.positions[v];
    if (v == 38) continue;
    EXPECT_EQ(p[2], p[0] < 500 ? a.at({p[0], p[1]}) : b.at({p[0] - 1000, p[1]}));
  }
}

TEST(subdivide, stale_polygon_marks_are_ignored_and_said) {
  GridMesh mesh = grid_mesh({5, 6}, {MeshForm::Diagonals::random, true, true});
  const auto expected = by_place(run(mesh.arrays, make_scheme("gentle"), {1}));
  mesh.arrays.inner_edges[3] = 0;
  mesh.arrays.inner_edges[7] = 7;
  Report report;
  EXPECT_EQ(by_place(subdivided(mesh.arrays, make_scheme("gentle"), {1}, report)), expected);
  EXPECT_NE(report.lines().front().find("polygon marks"), std::string::npos);
}

std::string refusal(const MeshArrays& mesh, const SubdivideOptions& options = {}) {
  try {
    (void)run(mesh, make_scheme("gentle"), options);
  } catch (const InvalidField& error) {
    return error.what();
  }
  return "not refused";
}

TEST(subdivide, hostile_meshes_are_refused_with_the_reason) {
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(refusal({}), "empty");
  MeshArrays points;
  points.positions.assign(5, {0, 0, 0});
  says(refusal(points), "5 points but no faces");

  MeshArrays nan = grid_mesh({4, 4}).arrays;
  nan.positions[6][2] = std::nan("");
  says(refusal(nan), "vertex 6");

  const auto without = [](const std::function<bool(Index, Index)>& missing) {
    GridMesh mesh = grid_mesh({6, 6});
    std::vector<Triangle> kept;
    for (std::size_t f = 0; f < mesh.arrays.triangles.size(); ++f) {
      const auto cell = static_cast<Index>(f / 2);
      if (!missing(cell / 5, cell % 5)) kept.push_back(mesh.arrays.triangles[f]);
    }
    mesh.arrays.triangles = kept;
    return mesh.arrays;
  };
  says(refusal(without([](Index r, Index c) { return r == 2 && c == 2; })), "not a terrain grid");
  says(refusal(without([](Index r, Index c) { return r > 2 && c > 2; })), "not a terrain grid");
  says(refusal(without([](Index r, Index c) { return r != c; })), "not a terrain grid");

  MeshArrays fan = grid_mesh({4, 4}).arrays;
  fan.positions.push_back({0, 0, 50});
  fan.triangles.push_back({fan.triangles[0][0], fan.triangles[0][1], 16});
  says(refusal(fan), "not a terrain grid");
  MeshArrays twice = grid_mesh({4, 4}).arrays;
  twice.triangles.push_back(twice.triangles[4]);
  says(refusal(twice), "not a terrain grid");
  MeshArrays wild = grid_mesh({4, 4}).arrays;
  wild.triangles[3][1] = 1000;
  says(refusal(wild), "not a terrain grid");

  MeshArrays tetrahedron;
  tetrahedron.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  tetrahedron.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}};
  says(refusal(tetrahedron), "not a terrain grid");
  tetrahedron.inner_edges = {1, 1, 1, 1};
  says(refusal(tetrahedron), "not a terrain grid");

  says(refusal(grid_mesh({40, 40}).arrays, {10}), "fewer levels");
}

}  // namespace
}  // namespace arete::meshlab

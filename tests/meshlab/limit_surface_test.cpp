// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/limit_surface.h"

#include <gtest/gtest.h>

#include "arete/analysis/limit_stencil.h"
#include "arete/analysis/polynomial.h"
#include "meshlab/grid_mesh.h"
#include "support/schemes.h"

namespace arete::meshlab {
namespace {

using test::grid_mesh;
using test::GridMesh;
using test::MeshForm;

MovedMesh run(const MeshArrays& mesh, const Scheme& scheme, const SubdivideOptions& options = {}) {
  Report report;
  return moved_to_limit(mesh, scheme, options, report);
}

double smooth(Index r, Index c) {
  return 30 * std::sin(0.3 * static_cast<double>(r)) * std::cos(0.2 * static_cast<double>(c));
}

// The vertices after many levels come to lie on the surface that the limit positions promise.
TEST(limit_surface, is_where_deep_subdivision_goes) {
  for (const char* text : {"b-spline:degree=2", "b-spline:degree=3", "chaikin", "gentle",
                           "four-point", "ternary-four-point", "b-spline:degree=4"}) {
    const Scheme scheme = parse_scheme(text);
    const int levels = scheme.mask().arity() == 2 ? 6 : 4;
    const GridMesh mesh = grid_mesh({5, 5}, {MeshForm::Diagonals::random, true, true});
    const MovedMesh moved = run(mesh.arrays, scheme);
    Report report;
    const RefinedMesh deep = subdivided(mesh.arrays, scheme, {levels}, report);
    for (std::size_t v = 0; v < mesh.arrays.positions.size(); ++v) {
      const Point3& p = moved.positions[v];
      EXPECT_NEAR(p[0], mesh.arrays.positions[v][0], 1e-12) << text;
      EXPECT_NEAR(p[1], mesh.arrays.positions[v][1], 1e-12) << text;
      double nearest = 1e9, height = 0;
      for (const Point3& q : deep.arrays.positions) {
        const double distance = std::hypot(q[0] - p[0], q[1] - p[1]);
        if (distance < nearest) {
          nearest = distance;
          height = q[2];
        }
      }
      // A height error of the slope (up to some 30 a unit) times the distance of the sample.
      EXPECT_NEAR(p[2], height, 30 * nearest + 0.2) << text;
    }
  }
}

TEST(limit_surface, planes_stay_planes_with_their_normal) {
  const auto plane = [](Index r, Index c) { return 3.0 * double(r) - 2.0 * double(c); };
  // dz/dx = -2/10, dz/dy = -3/20.
  const double length = std::sqrt(0.2 * 0.2 + 0.15 * 0.15 + 1);
  for (const Scheme& scheme : arete::test::sample_schemes()) {
    if (sum_rules(scheme.mask()) < 2) continue;  // linear data do not stay linear
    for (bool clockwise : {false, true}) {
      for (Coordinates coordinates : {Coordinates::heights, Coordinates::all}) {
        MeshForm form{MeshForm::Diagonals::random, false, true, clockwise};
        const GridMesh mesh = grid_mesh({5, 6}, form, plane);
        if (!limit_stencil(scheme.mask())) {
          EXPECT_THROW((void)run(mesh.arrays, scheme), InvalidScheme) << scheme.text();
          continue;
        }
        SubdivideOptions options;
        options.coordinates = coordinates;
        const MovedMesh moved = run(mesh.arrays, scheme, options);
        const double side = clockwise ? -1 : 1;
        for (std::size_t v = 0; v < moved.positions.size(); ++v) {
          const Point3& p = moved.positions[v];
          const double row = 4 - p[1] / 20;
          EXPECT_NEAR(p[2], 3 * row - 2 * p[0] / 10, 1e-9) << scheme.text();
          if (moved.normals.empty()) continue;
          EXPECT_NEAR(moved.normals[v][0], side * 0.2 / length, 1e-9) << scheme.text();
          EXPECT_NEAR(moved.normals[v][1], side * 0.15 / length, 1e-9) << scheme.text();
          EXPECT_NEAR(moved.normals[v][2], side / length, 1e-9) << scheme.text();
        }
        EXPECT_EQ(moved.normals.empty(), !derivative_stencil(scheme.mask())) << scheme.text();
      }
    }
  }
}

TEST(limit_surface, flat_ground_looks_up_whatever_the_boundary) {
  const GridMesh mesh = grid_mesh({5, 6}, {MeshForm::Diagonals::random, true, true},
                                  [](Index, Index) { return 4.0; });
  for (Boundary boundary :
       {Boundary::extrapolate, Boundary::clamp, Boundary::reflect, Boundary::periodic}) {
    const MovedMesh moved = run(mesh.arrays, make_scheme("gentle"), {0, boundary});
    for (const Point3& n : moved.normals) EXPECT_NEAR(n[2], 1, 1e-9) << int(boundary);
  }
}

TEST(limit_surface, a_reflected_rim_of_all_coordinates_has_no_normal) {
  // x does not change across a rim of reflected x: there the limit has no tangent plane.
  const GridMesh mesh = grid_mesh({5, 6}, {}, smooth);
  const MovedMesh moved =
      run(mesh.arrays, make_scheme("gentle"), {0, Boundary::reflect, Coordinates::all});
  for (Index r = 0; r < 5; ++r)
    for (Index c = 0; c < 6; ++c) {
      const Point3& n = moved.normals[static_cast<std::size_t>(mesh.vertex(r, c))];
      const bool rim = r == 0 || r == 4 || c == 0 || c == 5;
      EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), rim ? 0 : 1, 1e-9);
    }
}

TEST(limit_surface, normals_are_those_of_a_deeply_refined_mesh) {
  for (const char* text : {"b-spline:degree=3", "chaikin", "four-point", "b-spline:degree=4"}) {
    const Scheme scheme = parse_scheme(text);
    const GridMesh mesh = grid_mesh({6, 6}, {}, smooth);
    const MovedMesh moved = run(mesh.arrays, scheme);
    ASSERT_FALSE(moved.normals.empty());
    Report report;
    const RefinedMesh deep = subdivided(mesh.arrays, scheme, {6}, report);
    for (Index r = 1; r < 5; ++r) {
      for (Index c = 1; c < 5; ++c) {
        const auto v = static_cast<std::size_t>(mesh.vertex(r, c));
        const Point3& p = moved.positions[v];
        // Slopes by differences between the samples around the place.
        const auto height = [&](double x, double y) {
          const Point3* best = nullptr;
          double nearest = 1e9;
          for (const Point3& q : deep.arrays.positions) {
            const double d = std::hypot(q[0] - x, q[1] - y);
            if (d < nearest) {
              nearest = d;
              best = &q;
            }
          }
          return *best;
        };
        const Point3 e = height(p[0] + 0.5, p[1]), w = height(p[0] - 0.5, p[1]);
        const Point3 n = height(p[0], p[1] + 0.5), s = height(p[0], p[1] - 0.5);
        const double slope_x = (e[2] - w[2]) / (e[0] - w[0]);
        const double slope_y = (n[2] - s[2]) / (n[1] - s[1]);
        EXPECT_NEAR(-moved.normals[v][0] / moved.normals[v][2], slope_x, 0.06) << text;
        EXPECT_NEAR(-moved.normals[v][1] / moved.normals[v][2], slope_y, 0.06) << text;
      }
    }
  }
}

TEST(limit_surface, an_interpolating_scheme_moves_nothing) {
  const GridMesh mesh = grid_mesh({6, 6}, {MeshForm::Diagonals::random, true, true});
  EXPECT_EQ(run(mesh.arrays, make_scheme("four-point")).positions, mesh.arrays.positions);
}

TEST(limit_surface, refuses_what_has_no_limit_at_the_rim) {
  const GridMesh mesh = grid_mesh({6, 6});
  EXPECT_THROW((void)run(mesh.arrays, make_scheme("gentle"), {0, Boundary::none}), InvalidField);
  EXPECT_THROW(
      (void)run(mesh.arrays, make_scheme("gentle"), {0, Boundary::periodic, Coordinates::all}),
      InvalidField);
}

}  // namespace
}  // namespace arete::meshlab

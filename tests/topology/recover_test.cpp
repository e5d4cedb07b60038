// SPDX-License-Identifier: MIT
#include "arete/topology/recover.h"

#include <gtest/gtest.h>

#include "arete/topology/orient.h"
#include "arete/topology/recover_part.h"
#include "topology/meshes.h"

namespace arete {
namespace {

using test::Mesh;

// Whether the patch of a (shuffled) terrain is the terrain, turned or mirrored in one of the eight
// ways that map a grid to itself. Positions tell: vertex (r, c) of the terrain lies at (c, -r).
bool is_terrain(const GridPatch& patch, const std::vector<Point3>& points, Extent terrain) {
  const auto place = [&](Index r, Index c) {
    const Point3& p = points[static_cast<std::size_t>(patch.vertex(r, c))];
    return std::pair<Index, Index>(std::lround(-p[1]), std::lround(p[0]));
  };
  const bool turned = patch.extent != terrain;
  if (turned && patch.extent != Extent{terrain.cols, terrain.rows}) return false;
  const auto [r0, c0] = place(0, 0);
  const auto [r1, c1] = place(0, 1);
  const auto [r2, c2] = place(1, 0);
  for (Index r = 0; r < patch.extent.rows; ++r)
    for (Index c = 0; c < patch.extent.cols; ++c)
      if (place(r, c) != std::pair<Index, Index>(r0 + c * (r1 - r0) + r * (r2 - r0),
                                                 c0 + c * (c1 - c0) + r * (c2 - c0)))
        return false;
  return std::abs(r1 - r0) + std::abs(c1 - c0) == 1;
}

GridPatch only_patch(const Mesh& mesh, bool with_positions = true) {
  const auto patches = recover_grids(mesh.faces, mesh.vertices(),
                                     with_positions ? mesh.points : std::vector<Point3>{});
  EXPECT_EQ(patches.size(), 1u);
  EXPECT_TRUE(test::is_consistent(patches.front(), mesh.faces));
  return patches.front();
}

constexpr Extent sizes[]{{2, 2}, {2, 7}, {9, 2}, {5, 5}, {9, 6}, {17, 12}};

// Numbered row by row a grid is recognised at a glance; with two faces exchanged it has to be
// found. Both must say the same.
TEST(recover, a_grid_in_order_is_the_grid_that_is_found) {
  for (const Extent extent : {Extent{2, 2}, Extent{2, 5}, Extent{5, 2}, Extent{6, 9}}) {
    for (const bool turned : {false, true}) {
      Mesh mesh = test::terrain_mesh(extent.rows, extent.cols);
      if (turned) mesh = test::turned_over(mesh);
      EXPECT_TRUE(detail::recover_in_order(mesh.faces, mesh.vertices()));
      const GridPatch seen = oriented(only_patch(mesh), mesh.points);
      EXPECT_EQ(seen.extent, extent);
      if (mesh.faces.count() < 2) continue;
      Mesh other = mesh;
      std::swap_ranges(other.faces.corners.begin(), other.faces.corners.begin() + 4,
                       other.faces.corners.end() - 4);
      EXPECT_FALSE(detail::recover_in_order(other.faces, other.vertices()));
      const GridPatch found = oriented(only_patch(other), other.points);
      EXPECT_EQ(found.extent, seen.extent);
      EXPECT_EQ(found.vertices, seen.vertices);
      EXPECT_EQ(found.mirrored, seen.mirrored);
    }
  }
}

TEST(recover, what_only_begins_in_order_is_not_taken_for_a_grid) {
  const Mesh grid = test::terrain_mesh(4, 5);
  Mesh lone = grid;
  lone.points.push_back({9, 9, 9});
  EXPECT_FALSE(detail::recover_in_order(lone.faces, lone.vertices()));
  EXPECT_FALSE(detail::recover_in_order(FaceList{}, 0));
  EXPECT_FALSE(detail::recover_in_order(test::tube_mesh(3, 5).faces, 15));
  for (int f = 0; f < grid.faces.count(); ++f) {
    for (std::size_t corner = 0; corner < 4; ++corner) {
      Mesh broken = grid;
      broken.faces.corners[4 * static_cast<std::size_t>(f) + corner] ^= 1;
      EXPECT_FALSE(detail::recover_in_order(broken.faces, broken.vertices())) << f << " " << corner;
    }
    Mesh flipped = grid;
    std::reverse(flipped.faces.corners.begin() + 4 * f, flipped.faces.corners.begin() + 4 * f + 4);
    EXPECT_FALSE(detail::recover_in_order(flipped.faces, flipped.vertices())) << f;
  }
}

TEST(recover_grids, finds_a_grid_of_quads_in_any_order) {
  for (Extent extent : sizes) {
    const Mesh mesh = test::terrain_mesh(extent.rows, extent.cols);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const Mesh other = test::shuffled(mesh, seed);
      const GridPatch patch = only_patch(other, false);
      EXPECT_TRUE(is_terrain(patch, other.points, extent)) << extent.rows << " " << seed;
      EXPECT_FALSE(patch.wraps_rows || patch.wraps_cols || patch.is_triangulated());
    }
  }
}

TEST(recover_grids, finds_a_grid_of_triangles_whatever_the_diagonals) {
  for (Extent extent : sizes) {
    const Mesh quads = test::terrain_mesh(extent.rows, extent.cols);
    const int cols = static_cast<int>(extent.cols) - 1;
    for (unsigned seed = 0; seed < 60; ++seed) {
      std::mt19937 random(seed);
      for (int style = 0; style < 4; ++style) {
        const Mesh triangles = test::triangulated(quads, [&](int f) {
          if (style < 2) return style == 0;
          return style == 2 ? (f / cols + f % cols) % 2 == 0 : random() % 2 == 0;
        });
        const Mesh other = test::shuffled(triangles, seed);
        const GridPatch patch = only_patch(other);
        EXPECT_TRUE(is_terrain(patch, other.points, extent))
            << extent.rows << " x " << extent.cols << " style " << style << " seed " << seed;
      }
    }
  }
}

TEST(recover_grids, finds_every_triangulation_up_to_four_by_four) {
  int patterns = 0;
  for (Index rows = 2; rows <= 4; ++rows) {
    for (Index cols = 2; cols <= 4; ++cols) {
      const Mesh quads = test::terrain_mesh(rows, cols);
      for (int bits = 0; bits < 1 << quads.faces.count(); ++bits, ++patterns) {
        const Mesh mesh = test::triangulated(quads, [&](int f) { return (bits >> f & 1) != 0; });
        EXPECT_TRUE(is_terrain(only_patch(mesh), mesh.points, {rows, cols}))
            << rows << " x " << cols << ": " << bits;
      }
    }
  }
  EXPECT_EQ(patterns, 2 + 2 * 4 + 2 * 8 + 16 + 2 * 64 + 512);
}

TEST(recover_grids, a_corner_with_one_face_settles_triangles_without_positions) {
  for (Extent extent : sizes) {
    const Mesh quads = test::terrain_mesh(extent.rows, extent.cols);
    for (bool first : {false, true}) {
      const Mesh mesh = test::triangulated(quads, [&](int) { return first; });
      for (unsigned seed = 0; seed < 10; ++seed) {
        const Mesh other = test::shuffled(mesh, seed);
        EXPECT_TRUE(is_terrain(only_patch(other, false), other.points, extent));
      }
    }
  }
}

TEST(recover_grids, finds_tubes_and_tori) {
  for (unsigned seed = 0; seed < 60; ++seed) {
    const Mesh tube = test::shuffled(test::tube_mesh(4, 9), seed);
    const GridPatch round = only_patch(tube, false);
    EXPECT_NE(round.wraps_rows, round.wraps_cols);
    EXPECT_EQ(round.wraps_cols ? round.extent : (Extent{round.extent.cols, round.extent.rows}),
              (Extent{4, 9}));
    const Mesh torus = test::shuffled(test::torus_mesh(5, 8), seed);
    const GridPatch ring = only_patch(torus, false);
    EXPECT_TRUE(ring.wraps_rows && ring.wraps_cols);
    EXPECT_EQ(ring.extent.rows * ring.extent.cols, 40);
  }
}

TEST(recover_grids, finds_several_patches_and_leaves_lone_vertices_out) {
  Mesh mesh = test::joined(test::terrain_mesh(4, 6), test::tube_mesh(3, 5));
  mesh =
      test::joined(mesh, test::triangulated(test::terrain_mesh(3, 3), [](int f) { return f % 2; }));
  mesh.points.push_back({9, 9, 9});
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Mesh other = test::shuffled(mesh, seed);
    const auto patches = recover_grids(other.faces, other.vertices(), other.points);
    ASSERT_EQ(patches.size(), 3u);
    std::size_t vertices = 0;
    for (const GridPatch& patch : patches) {
      EXPECT_TRUE(test::is_consistent(patch, other.faces));
      vertices += patch.vertices.size();
    }
    EXPECT_EQ(vertices, mesh.points.size() - 1);
  }
}

TEST(recover_grids, many_small_patches_cost_no_more_than_one_large) {
  // 20,000 separate quads: quadratic work would take minutes.
  Mesh mesh;
  for (int i = 0; i < 20000; ++i) {
    for (int k = 0; k < 4; ++k) mesh.points.push_back({});
    mesh.faces.add(std::vector<int>{4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  }
  EXPECT_EQ(recover_grids(mesh.faces, mesh.vertices()).size(), 20000u);
}

TEST(recover_grids, an_empty_mesh_has_no_patch) {
  EXPECT_TRUE(recover_grids({}, 0).empty());
  EXPECT_TRUE(recover_grids({}, 3).empty());
}

}  // namespace
}  // namespace arete

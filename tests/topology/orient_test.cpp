// SPDX-License-Identifier: MIT
#include "arete/topology/orient.h"

#include <gtest/gtest.h>

#include "arete/topology/recover.h"
#include "topology/meshes.h"

namespace arete {
namespace {

using test::Mesh;

// The positions of an oriented patch, in its order: what a refinement sees.
std::vector<Point3> seen(const GridPatch& patch, const std::vector<Point3>& points) {
  std::vector<Point3> result;
  for (int v : patch.vertices) result.push_back(points[static_cast<std::size_t>(v)]);
  return result;
}

GridPatch oriented_patch(const Mesh& mesh) {
  const auto patches = recover_grids(mesh.faces, mesh.vertices(), mesh.points);
  const GridPatch patch = oriented(patches.at(0), mesh.points);
  EXPECT_TRUE(test::is_consistent(patch, mesh.faces));
  return patch;
}

TEST(oriented, terrain_comes_out_as_a_raster_north_west_first) {
  for (Extent extent : {Extent{4, 4}, Extent{3, 8}, Extent{7, 2}}) {
    const Mesh mesh = test::terrain_mesh(extent.rows, extent.cols);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const Mesh quads = test::shuffled(mesh, seed);
      const GridPatch patch = oriented_patch(quads);
      EXPECT_EQ(patch.extent, extent);
      EXPECT_EQ(seen(patch, quads.points), mesh.points);
      EXPECT_TRUE(patch.mirrored) << "faces that look up are clockwise when rows go south";

      std::mt19937 random(seed);
      const Mesh triangles =
          test::shuffled(test::triangulated(mesh, [&](int) { return random() % 2 == 0; }), seed);
      EXPECT_EQ(seen(oriented_patch(triangles), triangles.points), mesh.points);
    }
  }
}

TEST(oriented, faces_that_look_down_are_not_mirrored) {
  Mesh mesh = test::terrain_mesh(3, 5);
  mesh.faces = grid_faces({3, 5});
  const GridPatch patch = oriented_patch(test::shuffled(mesh, 4));
  EXPECT_FALSE(patch.mirrored);
}

TEST(oriented, does_not_depend_on_the_numbering) {
  std::vector<Mesh> meshes{test::tube_mesh(4, 9), test::torus_mesh(5, 8), test::torus_mesh(6, 6),
                           test::terrain_mesh(5, 5), test::terrain_mesh(4, 6)};
  // Standing upright and turned by 45 degrees: nothing distinguishes rows from columns but
  // coordinates.
  for (Point3& p : meshes[3].points) p = {p[0] - p[1], p[0] + p[1], p[2]};
  for (Point3& p : meshes[4].points) p = {p[2], 0, p[0] + 0.25 * p[1]};
  for (const Mesh& mesh : meshes) {
    const Mesh first = test::shuffled(mesh, 1000);
    const std::vector<Point3> expected = seen(oriented_patch(first), first.points);
    for (unsigned seed = 0; seed < 60; ++seed) {
      const Mesh other = test::shuffled(mesh, seed);
      EXPECT_EQ(seen(oriented_patch(other), other.points), expected) << seed;
    }
  }
}

TEST(oriented, a_tube_has_its_columns_around) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const GridPatch patch = oriented_patch(test::shuffled(test::tube_mesh(4, 9), seed));
    EXPECT_EQ(patch.extent, (Extent{4, 9}));
    EXPECT_TRUE(patch.wraps_cols);
    EXPECT_FALSE(patch.wraps_rows);
  }
}

}  // namespace
}  // namespace arete

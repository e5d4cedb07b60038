// SPDX-License-Identifier: MIT
#include "arete/topology/height_mesh.h"

#include <gtest/gtest.h>

#include "arete/field/error.h"
#include "support/fields.h"
#include "topology/meshes.h"

namespace arete {
namespace {

TEST(height_mesh, heights_come_back_from_the_shuffled_mesh) {
  for (const Extent extent : {Extent{2, 2}, Extent{3, 7}, Extent{7, 3}}) {
    const Grid<double> heights = test::random_heights(extent);
    const test::Mesh mesh{height_points(heights), grid_faces(extent, true)};
    for (unsigned seed = 0; seed < 5; ++seed) {
      const test::Mesh other = test::shuffled(mesh, seed);
      const Grid<double> back = heights_of(other.faces, other.points);
      ASSERT_EQ(back.extent(), extent);
      EXPECT_EQ(back.samples(), heights.samples());
    }
  }
}

TEST(height_mesh, what_is_not_one_grid_is_refused) {
  EXPECT_THROW((void)heights_of({}, {{0, 0, 0}}), InvalidField);
  const test::Mesh two = test::joined(test::terrain_mesh(2, 3), test::terrain_mesh(2, 2));
  EXPECT_THROW((void)heights_of(two.faces, two.points), InvalidField);
}

}  // namespace
}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/block_walls.h"

#include <gtest/gtest.h>
#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>

#include <cmath>

#include "arete/vtk/internal/quads.h"
#include "fixtures.h"

namespace arete::vtk {
namespace {

struct Wall {
  std::array<Vector3, 4> corners;
  Vector3 normal;
};

std::vector<Wall> walls_of(const Surface& surface) {
  const Stage stage(surface, local_plane(surface), 0, 1);
  vtkNew<vtkActor> actor;
  set_block_walls(stage, -50, *actor);
  auto* mesh = vtkPolyDataMapper::SafeDownCast(actor->GetMapper())->GetInput();
  std::vector<Wall> walls(static_cast<std::size_t>(mesh->GetNumberOfPolys()));
  for (std::size_t k = 0; k < walls.size(); ++k) {
    for (std::size_t c = 0; c < 4; ++c) {
      mesh->GetPoint(static_cast<vtkIdType>(4 * k + c), walls[k].corners[c].data());
    }
    mesh->GetPointData()->GetNormals()->GetTuple(static_cast<vtkIdType>(4 * k),
                                                 walls[k].normal.data());
  }
  return walls;
}

Vector3 minus(const Vector3& a, const Vector3& b) {
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

TEST(block_walls, stand_all_around_and_look_outwards) {
  for (const Georeference& georeference : {north_up, south_up, rotated, sheared, mirrored}) {
    const auto grid = planted<float>({4, 6}, georeference, [](double, double) { return 7; });
    const auto walls = walls_of(surface_of(grid, georeference));
    EXPECT_EQ(walls.size(), 2u * (3 + 5));
    for (const auto& [corners, normal] : walls) {
      const Vector3 along = minus(corners[1], corners[0]);
      const Vector3 up = minus(corners[3], corners[0]);
      EXPECT_EQ(up, (Vector3{0, 0, 57})) << "from the foot to the height";
      EXPECT_NEAR(std::hypot(normal[0], normal[1]), 1, 1e-6);
      EXPECT_NEAR(normal[0] * along[0] + normal[1] * along[1], 0, 1e-5);
      // The terrain lies about the origin and is convex: outwards is away from it.
      EXPECT_GT(normal[0] * corners[0][0] + normal[1] * corners[0][1], 0);
      // Counter-clockwise seen from outside: along x up points along the normal.
      EXPECT_GT(along[1] * up[2] * normal[0] - along[0] * up[2] * normal[1], 0);
    }
  }
}

TEST(block_walls, follow_a_ragged_edge_and_leave_holes_open) {
  auto grid = planted<float>({6, 6}, north_up, plane_height);
  const auto full = walls_of(surface_of(grid, north_up)).size();
  EXPECT_EQ(full, 20u);
  grid(3, 2) = missing;  // a hole inside
  EXPECT_EQ(walls_of(surface_of(grid, north_up)).size(), full);
  grid(0, 0) = missing;  // a corner less: the way around is as long
  EXPECT_EQ(walls_of(surface_of(grid, north_up)).size(), full);
  grid(0, 3) = missing;  // a bay of 2 x 1 quads in the northern edge
  EXPECT_EQ(walls_of(surface_of(grid, north_up)).size(), full + 2);
}

}  // namespace
}  // namespace arete::vtk

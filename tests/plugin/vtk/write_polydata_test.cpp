// SPDX-License-Identifier: MIT
#include "arete/vtk/write_polydata.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <cmath>
#include <set>

#include "fixtures.h"
#include "reading.h"

namespace arete::vtk {
namespace {

constexpr Extent extent{4, 5};
using Point = std::array<double, 3>;

vtkSmartPointer<vtkPolyData> written(const Surface& surface) {
  const Scratch scratch;
  write_polydata(surface, scratch / "a.vtp");
  return read_back<vtkXMLPolyDataReader>(scratch / "a.vtp");
}

std::vector<Point> corners(vtkPolyData& mesh, vtkIdType cell) {
  vtkNew<vtkIdList> ids;
  mesh.GetCellPoints(cell, ids);
  std::vector<Point> points(static_cast<std::size_t>(ids->GetNumberOfIds()));
  for (std::size_t k = 0; k < points.size(); ++k) {
    mesh.GetPoint(ids->GetId(static_cast<vtkIdType>(k)), points[k].data());
  }
  return points;
}

/// Twice the area of the polygon seen from above, positive when it turns counter-clockwise.
double turning(const std::vector<Point>& points) {
  double area = 0;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const Point& a = points[k];
    const Point& b = points[(k + 1) % points.size()];
    area += a[0] * b[1] - a[1] * b[0];
  }
  return area / 2;
}

class EveryMap : public testing::TestWithParam<Georeference> {};
INSTANTIATE_TEST_SUITE_P(write_polydata, EveryMap,
                         testing::Values(north_up, south_up, mirrored, rotated, quarter_turn,
                                         sheared));

TEST_P(EveryMap, quads_tile_the_raster_counter_clockwise) {
  const auto grid = planted<double>(extent, GetParam(), plane_height);
  const auto mesh = written(surface_of(grid, GetParam()));
  ASSERT_EQ(mesh->GetNumberOfPolys(), 12);
  const auto& g = GetParam().affine;
  const double area = std::abs(g[1] * g[5] - g[2] * g[4]);
  std::set<Point> centres;
  for (vtkIdType cell = 0; cell < 12; ++cell) {
    const auto quad = corners(*mesh, cell);
    ASSERT_EQ(quad.size(), 4u);
    EXPECT_NEAR(turning(quad), area, 1e-9) << "whole, simple and counter-clockwise";
    Point centre{};
    for (const Point& corner : quad) {
      for (std::size_t k = 0; k < 3; ++k) centre[k] += corner[k] / 4;
      EXPECT_NEAR(corner[2], plane_height(corner[0], corner[1]), 1e-9);
    }
    centres.insert(centre);
  }
  EXPECT_EQ(centres.size(), 12u) << "no quad twice";
}

TEST_P(EveryMap, normals_look_up_and_stand_upright_on_the_plane) {
  const auto grid = planted<double>(extent, GetParam(), plane_height);
  const auto mesh = written(surface_of(grid, GetParam()));
  auto* normals = mesh->GetPointData()->GetNormals();
  ASSERT_NE(normals, nullptr);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point) {
    Point normal{};
    normals->GetTuple(point, normal.data());
    EXPECT_GT(normal[2], 0);
    EXPECT_NEAR(normal[0] + 3 * normal[2], 0, 1e-6);  // at right angles to (1, 0, 3)
    EXPECT_NEAR(normal[1] - 2 * normal[2], 0, 1e-6);  // and to (0, 1, -2)
  }
}

TEST(write_polydata, a_quad_with_a_missing_corner_is_left_out_and_so_are_points_without_quads) {
  auto grid = planted<float>(extent, north_up, plane_height);
  grid(0, 1) = missing;  // leaves the corner sample (0, 0) without a quad
  grid(3, 3) = missing;  // and this one (3, 4)
  const auto mesh = written(surface_of(grid, north_up));
  EXPECT_EQ(mesh->GetNumberOfPolys(), 12 - 2 - 2);
  EXPECT_EQ(mesh->GetNumberOfPoints(), 20 - 2 - 2);
  EXPECT_EQ(ghosts(*mesh), nullptr);
  for (vtkIdType point = 0; point < mesh->GetNumberOfPoints(); ++point) {
    Point at{};
    mesh->GetPoint(point, at.data());
    EXPECT_EQ(at[2], plane_height(at[0], at[1]));
    EXPECT_EQ(value(*mesh, "height", point), at[2]);
  }
  for (vtkIdType cell = 0; cell < mesh->GetNumberOfPolys(); ++cell) {
    EXPECT_EQ(turning(corners(*mesh, cell)), 8) << "no quad was stretched over a hole";
  }
}

TEST(write_polydata, points_come_in_the_raster_s_order) {
  const auto grid = planted<float>(extent, north_up, plane_height);
  const auto mesh = written(surface_of(grid, north_up));
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      EXPECT_EQ(value(*mesh, "height", r * extent.cols + c), grid(r, c));
    }
  }
}

TEST(write_polydata, ids_that_fit_are_32_bits_wide) {
  const Scratch scratch;
  const auto grid = planted<float>(extent, north_up, plane_height);
  write_polydata(surface_of(grid, north_up), scratch / "a.vtp");
  const std::string file = contents(scratch / "a.vtp");
  const auto polys = file.find("<Polys>");
  const std::string cells = file.substr(polys, file.find("</Polys>") - polys);
  EXPECT_NE(cells.find("type=\"Int32\" Name=\"connectivity\""), std::string::npos) << cells;
  EXPECT_EQ(cells.find("Int64"), std::string::npos) << cells;
}

TEST(write_polydata, refuses_a_raster_without_a_whole_quad) {
  const Scratch scratch;
  Grid<float> sparse(extent, missing);
  for (Index c = 0; c < extent.cols; ++c) sparse(1, c) = 1;  // one row of samples
  EXPECT_THROW(write_polydata(surface_of(sparse, north_up), scratch / "a.vtp"), InvalidField);
  EXPECT_FALSE(std::filesystem::exists(scratch / "a.vtp"));
}

}  // namespace
}  // namespace arete::vtk

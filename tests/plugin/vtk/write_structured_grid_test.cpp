// SPDX-License-Identifier: MIT
#include "arete/vtk/write_structured_grid.h"

#include <gtest/gtest.h>
#include <vtkDataSetAttributes.h>
#include <vtkGeometryFilter.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStructuredGrid.h>
#include <vtkXMLStructuredGridReader.h>

#include <array>
#include <cmath>
#include <numbers>

#include "fixtures.h"
#include "reading.h"

namespace arete::vtk {
namespace {

constexpr Extent extent{5, 7};
using Point = std::array<double, 3>;

vtkSmartPointer<vtkStructuredGrid> written(const Surface& surface) {
  const Scratch scratch;
  write_structured_grid(surface, scratch / "a.vts");
  return read_back<vtkXMLStructuredGridReader>(scratch / "a.vts");
}

Point point(vtkDataSet& data, vtkIdType id) {
  Point at{};
  data.GetPoint(id, at.data());
  return at;
}

double degrees(double tangent) { return std::atan(tangent) * 180 / std::numbers::pi; }

class EveryPlanarMap : public testing::TestWithParam<Georeference> {};
INSTANTIATE_TEST_SUITE_P(write_structured_grid, EveryPlanarMap,
                         testing::Values(north_up, south_up, mirrored, rotated, quarter_turn,
                                         sheared, utm));

TEST_P(EveryPlanarMap, every_sample_is_a_point_at_its_world_position) {
  const auto grid = planted<double>(extent, GetParam(), plane_height);
  const auto data = written(surface_of(grid, GetParam()));
  ASSERT_EQ(data->GetNumberOfPoints(), 35);
  EXPECT_EQ(data->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (Index r = 0; r < extent.rows; ++r) {
    for (Index c = 0; c < extent.cols; ++c) {
      const WorldPoint at = GetParam().position(static_cast<double>(r), static_cast<double>(c));
      bool found = false;
      for (vtkIdType id = 0; id < 35; ++id) {
        found = found || point(*data, id) == Point{at.x, at.y, grid(r, c)};
      }
      EXPECT_TRUE(found) << "no point exactly at sample " << r << ", " << c;
    }
  }
}

TEST_P(EveryPlanarMap, a_plane_has_its_slope_and_normal_everywhere) {
  const auto grid = planted<double>(extent, GetParam(), plane_height);
  const auto data = written(surface_of(grid, GetParam()));
  ASSERT_STREQ(data->GetPointData()->GetNormals()->GetName(), "Normals");
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id) {
    EXPECT_NEAR(value(*data, "slope", id), degrees(std::sqrt(13.0)), 1e-5);
    Point normal{};
    data->GetPointData()->GetNormals()->GetTuple(id, normal.data());
    EXPECT_NEAR(normal[0], -3 / std::sqrt(14.0), 1e-6);
    EXPECT_NEAR(normal[1], 2 / std::sqrt(14.0), 1e-6);
    EXPECT_NEAR(normal[2], 1 / std::sqrt(14.0), 1e-6);
  }
}

TEST_P(EveryPlanarMap, cells_turn_counter_clockwise_seen_from_above) {
  const auto grid = planted<float>(extent, GetParam(), plane_height);
  const auto data = written(surface_of(grid, GetParam()));
  // i before j: the cell's corners 0 and 1 lie along i, 0 and 2 along j.
  const Point at = point(*data, 0);
  const Point i = point(*data, 1);
  const Point j = point(*data, extent.cols);
  EXPECT_GT((i[0] - at[0]) * (j[1] - at[1]) - (i[1] - at[1]) * (j[0] - at[0]), 0);
}

TEST(write_structured_grid, given_gradients_win_over_differences) {
  const Grid<float> level(extent, 5);
  const Grid<float> east(extent, 0.5f);
  Grid<float> north(extent, -1);
  north(2, 3) = missing;
  Surface surface = surface_of(level, north_up);
  surface.gradients.emplace(Gradients{east.view(), std::as_const(north).view()});
  const auto data = written(surface);
  int by_difference = 0;
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id) {
    if (value(*data, "slope", id) == 0) {
      ++by_difference;  // the one without a gradient falls back on the level heights
    } else {
      EXPECT_NEAR(value(*data, "slope", id), degrees(std::hypot(0.5, 1.0)), 1e-5);
    }
  }
  EXPECT_EQ(by_difference, 1);
}

TEST(write_structured_grid, differences_are_central_inside_and_one_sided_beside_holes) {
  // z = x^2 along one axis: central differences at x give 2 x, one-sided ones 2 x + 1 or 2 x - 1.
  const Georeference unit{{-0.5, 1, 0, 2.5, 0, -1}};
  auto grid = planted<double>({3, 6}, unit, [](double x, double) { return x * x; });
  grid(1, 3) = missing;
  const auto data = written(surface_of(grid, unit));
  const auto slope = [&](double x, double y) {
    std::array<double, 3> at{x, y, x * x};
    return value(*data, "slope", data->FindPoint(at.data()));
  };
  EXPECT_NEAR(slope(2, 2), degrees(4), 1e-5) << "inside";
  EXPECT_NEAR(slope(0, 1), degrees(1), 1e-5) << "at the western border";
  EXPECT_NEAR(slope(5, 1), degrees(9), 1e-5) << "at the eastern border";
  EXPECT_NEAR(slope(2, 1), degrees(3), 1e-5) << "west of the hole";
  EXPECT_NEAR(slope(4, 1), degrees(9), 1e-5) << "east of the hole";
}

TEST(write_structured_grid, geographic_points_are_metres_about_the_centre) {
  const Extent small{11, 9};
  const auto grid = planted<float>(small, jacksboro, [](double, double) { return 0; });
  Surface surface = surface_of(grid, jacksboro);
  surface.coordinates = Coordinates::geographic;
  const auto data = written(surface);
  // The distance between neighbours on the sphere, by the haversine formula.
  constexpr double radian = std::numbers::pi / 180;
  const auto haversine = [](WorldPoint a, WorldPoint b) {
    const double s = std::sin((b.y - a.y) * radian / 2);
    const double t = std::sin((b.x - a.x) * radian / 2);
    return 2 * 6371008.8 *
           std::asin(std::sqrt(s * s + std::cos(a.y * radian) * std::cos(b.y * radian) * t * t));
  };
  const double across = haversine(jacksboro.position(5, 4), jacksboro.position(5, 5));
  const double along = haversine(jacksboro.position(5, 4), jacksboro.position(4, 4));
  const Point centre = point(*data, 5 * 9 + 4);
  const Point east = point(*data, 5 * 9 + 5);
  const Point north = point(*data, 6 * 9 + 4);
  EXPECT_NEAR(centre[0], 0, 1e-9);
  EXPECT_NEAR(centre[1], 0, 1e-9);
  EXPECT_NEAR(east[0], across, 1e-6 * across);
  EXPECT_NEAR(east[1], 0, 1e-9);
  EXPECT_NEAR(north[0], 0, 1e-9);
  EXPECT_NEAR(north[1], along, 1e-6 * along);
  const std::string note = field_text(*data, "local_plane");
  EXPECT_NE(note.find("longitude -84.41"), std::string::npos) << note;
  EXPECT_NE(note.find("latitude 36.728"), std::string::npos) << note;
}

TEST(write_structured_grid, geographic_slopes_are_metres_per_metre) {
  // One metre up for two metres east; a degree of longitude at the centre is so many metres.
  const double latitude = jacksboro.position(5, 4).y;
  const double metres =
      6371008.8 * std::numbers::pi / 180 * std::cos(latitude * std::numbers::pi / 180);
  const auto grid = planted<double>({11, 9}, jacksboro,
                                    [&](double x, double) { return 0.5 * metres * (x + 84.41); });
  Surface surface = surface_of(grid, jacksboro);
  surface.coordinates = Coordinates::geographic;
  const auto by_difference = written(surface);
  const Grid<float> east({11, 9}, static_cast<float>(0.5 * metres));
  const Grid<float> north({11, 9}, 0);
  surface.gradients.emplace(Gradients{east.view(), north.view()});
  const auto by_gradient = written(surface);
  for (vtkIdType id = 0; id < 99; ++id) {
    EXPECT_NEAR(value(*by_difference, "slope", id), degrees(0.5), 1e-4);
    EXPECT_NEAR(value(*by_gradient, "slope", id), degrees(0.5), 1e-4);
  }
}

TEST(write_structured_grid, planar_surfaces_need_no_local_plane) {
  const auto grid = planted<float>(extent, utm, plane_height);
  EXPECT_EQ(field_text(*written(surface_of(grid, utm)), "local_plane"), "(none)");
}

TEST(write_structured_grid, missing_samples_are_hidden_and_leave_bounds_finite) {
  auto grid = planted<float>(extent, north_up, plane_height);
  grid(2, 3) = missing;
  const auto data = written(surface_of(grid, north_up));
  int hidden = 0;
  ASSERT_NE(ghosts(*data), nullptr);
  double lowest = std::numeric_limits<double>::infinity();
  for (const float height : grid.samples()) {
    if (std::isfinite(height)) lowest = std::min<double>(lowest, height);
  }
  for (vtkIdType id = 0; id < data->GetNumberOfPoints(); ++id) {
    const bool valid = std::isfinite(value(*data, "height", id));
    EXPECT_EQ(ghosts(*data)->GetValue(id), valid ? 0 : vtkDataSetAttributes::HIDDENPOINT);
    EXPECT_EQ(std::isfinite(value(*data, "slope", id)), valid);
    if (!valid) {
      ++hidden;
      EXPECT_EQ(point(*data, id)[2], lowest);
    }
  }
  EXPECT_EQ(hidden, 1);
  vtkNew<vtkGeometryFilter> drawn;
  drawn->SetInputData(data);
  drawn->Update();
  EXPECT_EQ(drawn->GetOutput()->GetNumberOfPolys(), 4 * 6 - 4) << "VTK leaves out the cells around";
}

TEST(write_structured_grid, heights_keep_their_type) {
  const auto doubles = planted<double>(extent, north_up, plane_height);
  const auto floats = planted<float>(extent, north_up, plane_height);
  const auto type = [](vtkDataSet& data, const char* name) {
    return data.GetPointData()->GetArray(name)->GetDataType();
  };
  EXPECT_EQ(type(*written(surface_of(doubles, north_up)), "height"), VTK_DOUBLE);
  EXPECT_EQ(type(*written(surface_of(floats, north_up)), "height"), VTK_FLOAT);
  EXPECT_EQ(type(*written(surface_of(doubles, north_up)), "slope"), VTK_FLOAT);
}

}  // namespace
}  // namespace arete::vtk

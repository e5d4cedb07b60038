// SPDX-License-Identifier: MIT
#include "arete/vtk/write_polyline.h"

#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkIdList.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include <array>
#include <vector>

#include "fixtures.h"
#include "reading.h"

namespace arete::vtk {
namespace {

Grid<double> points_of(std::initializer_list<std::vector<double>> rows) {
  Grid<double> grid({std::ssize(rows), std::ssize(*rows.begin())});
  Index r = 0;
  for (const auto& row : rows) {
    for (std::size_t c = 0; c < row.size(); ++c) grid(r, static_cast<Index>(c)) = row[c];
    ++r;
  }
  return grid;
}

vtkSmartPointer<vtkPolyData> written(const Polyline& line) {
  const Scratch scratch;
  write_polyline(line, scratch / "a.vtp");
  return read_back<vtkXMLPolyDataReader>(scratch / "a.vtp");
}

std::vector<vtkIdType> path_of(vtkPolyData& curve) {
  vtkNew<vtkIdList> ids;
  curve.GetCellPoints(0, ids);
  return {ids->begin(), ids->end()};
}

TEST(write_polyline, an_open_curve_visits_its_points_in_order) {
  const auto points = points_of({{5e6 + 0.125, 1}, {2, 3}, {4, -1}});
  const auto curve = written({std::as_const(points).view()});
  ASSERT_EQ(curve->GetNumberOfLines(), 1);
  EXPECT_EQ(path_of(*curve), (std::vector<vtkIdType>{0, 1, 2}));
  EXPECT_EQ(curve->GetPoints()->GetDataType(), VTK_DOUBLE);
  for (Index r = 0; r < 3; ++r) {
    std::array<double, 3> at{};
    curve->GetPoint(r, at.data());
    EXPECT_EQ(at, (std::array<double, 3>{points(r, 0), points(r, 1), 0}));
  }
}

TEST(write_polyline, a_closed_curve_returns_to_its_first_point_without_repeating_it) {
  const auto points = points_of({{0, 0, 1}, {1, 0, 2}, {0, 1, 3}});
  const auto curve = written({std::as_const(points).view(), true});
  EXPECT_EQ(curve->GetNumberOfPoints(), 3);
  EXPECT_EQ(path_of(*curve), (std::vector<vtkIdType>{0, 1, 2, 0}));
  for (Index r = 0; r < 3; ++r) EXPECT_EQ(curve->GetPoint(r)[2], points(r, 2));
}

TEST(write_polyline, parameters_are_the_scalars_tau) {
  const auto points = points_of({{0, 0}, {1, 0}});
  const std::vector<double> tau{-0.25, 1.0 / 3};
  const auto curve = written({std::as_const(points).view(), false, tau});
  ASSERT_NE(curve->GetPointData()->GetScalars(), nullptr);
  EXPECT_STREQ(curve->GetPointData()->GetScalars()->GetName(), "tau");
  EXPECT_EQ(value(*curve, "tau", 0), -0.25);
  EXPECT_EQ(value(*curve, "tau", 1), 1.0 / 3);
  const auto bare = written({std::as_const(points).view()});
  EXPECT_EQ(bare->GetPointData()->GetNumberOfArrays(), 0);
}

TEST(write_polyline, refuses_what_is_no_curve) {
  const Scratch scratch;
  const auto refused = [&](const Polyline& line) {
    EXPECT_THROW(write_polyline(line, scratch / "a.vtp"), InvalidField);
    EXPECT_FALSE(std::filesystem::exists(scratch / "a.vtp"));
  };
  const auto one = points_of({{0, 0}});
  const auto two = points_of({{0, 0}, {1, 1}});
  const auto flat = points_of({{0}, {1}});
  const auto deep = points_of({{0, 0, 0, 0}, {1, 1, 1, 1}});
  const auto broken = points_of({{0, 0}, {1, std::numeric_limits<double>::quiet_NaN()}});
  const std::vector<double> short_tau{1};
  refused({one.view()});
  refused({two.view(), true});
  refused({flat.view()});
  refused({deep.view()});
  refused({broken.view()});
  refused({two.view(), false, short_tau});
  write_polyline({two.view()}, scratch / "a.vtp");
  EXPECT_TRUE(std::filesystem::exists(scratch / "a.vtp"));
}

}  // namespace
}  // namespace arete::vtk

// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <vtkAreteRefineImage.h>
#include <vtkAreteSurface.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include <cmath>
#include <map>

#include "arete/analysis/limit_stencil.h"
#include "plugin/vtk/filters/exact_source.h"
#include "plugin/vtk/filters/images.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

vtkSmartPointer<vtkPolyData> surface(vtkImageData* image, const std::string& scheme,
                                     bool limit = false, int missing = vtkAreteSurface::DROP) {
  const vtkNew<vtkAreteSurface> filter;
  filter->SetInputData(image);
  filter->SetScheme(scheme.c_str());
  filter->SetLimit(limit);
  filter->SetMissing(missing);
  filter->Update();
  return filter->GetPolyDataOutput();
}

std::array<double, 3> normal(vtkPolyData* mesh, vtkIdType point) {
  std::array<double, 3> n{};
  mesh->GetPointData()->GetNormals()->GetTuple(point, n.data());
  return n;
}

// The normal by the faces around, an oracle that knows nothing of schemes.
std::array<double, 3> face_normal(vtkPolyData* mesh, vtkIdType cell) {
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  mesh->GetCellPoints(cell, size, ids);
  double p[3], q[3], r[3];
  mesh->GetPoint(ids[0], p);
  mesh->GetPoint(ids[1], q);
  mesh->GetPoint(ids[2], r);
  std::array<double, 3> n{};
  for (std::size_t a = 0; a < 3; ++a) {
    const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
    n[a] = (q[b] - p[b]) * (r[c] - p[c]) - (q[c] - p[c]) * (r[b] - p[b]);
  }
  const double length = std::hypot(n[0], n[1], n[2]);
  for (double& v : n) v /= length;
  return n;
}

TEST(surface, a_plane_has_its_normal_everywhere_for_every_scheme_and_frame) {
  const double direction[9]{0, -1, 0, 1, 0, 0, 0, 0, 1};
  int with_limits = 0;
  for (const Scheme& scheme : test::sample_schemes()) {
    const auto image = test::image_of(test::plane<double>({6, 7}, 3, 0.5, -2), {4, -1});
    image->SetSpacing(2, 0.25, 1);
    image->SetOrigin(10, 20, 30);
    image->SetDirectionMatrix(direction);
    const auto mesh = surface(image, scheme.text());
    ASSERT_EQ(mesh->GetNumberOfPoints(), 42);
    ASSERT_EQ(mesh->GetNumberOfCells(), 30);
    const auto* note =
        vtkStringArray::SafeDownCast(mesh->GetFieldData()->GetAbstractArray("AreteNormals"));
    const bool limits = note && const_cast<vtkStringArray*>(note)->GetValue(0) == "limit surface";
    EXPECT_EQ(limits, derivative_stencil(scheme.mask()).has_value()) << scheme.text();
    with_limits += limits ? 1 : 0;
    // Along i the height falls by 2 in 2, along j it rises by 0.5 in 0.25; i is the world's y.
    const double length = std::hypot(1, 2, 1);
    const std::array<double, 3> expected{2 / length, 1 / length, 1 / length};
    for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); ++i) {
      for (std::size_t a = 0; a < 3; ++a)
        ASSERT_NEAR(normal(mesh, i)[a], expected[a], 1e-6) << scheme.text();
      EXPECT_NEAR(mesh->GetPointData()->GetArray("Slope")->GetTuple1(i),
                  std::acos(1 / length) * 180 / M_PI, 1e-4);
    }
    for (vtkIdType f = 0; f < mesh->GetNumberOfCells(); ++f)
      for (std::size_t a = 0; a < 3; ++a) ASSERT_NEAR(face_normal(mesh, f)[a], expected[a], 1e-9);
  }
  EXPECT_GT(with_limits, 15);
}

// Limit points of a dyadic refinement are dense, so the slope of their chords tends to the normal.
TEST(surface, normals_are_those_of_the_limit_surface) {
  const Grid<double> heights = test::random_heights({6, 6});
  for (const char* scheme : {"b-spline:degree=3", "b-spline:degree=5", "four-point", "chaikin"}) {
    const vtkNew<vtkAreteRefineImage> fine;
    fine->SetInputData(test::image_of(heights));
    fine->SetScheme(scheme);
    fine->SetLevels(7);
    fine->LimitOn();
    fine->Update();
    const Grid<double> limit = test::grid_of(fine->GetOutput());
    const double* origin = fine->GetOutput()->GetOrigin();
    const double h = fine->GetOutput()->GetSpacing()[0];
    const int* e = fine->GetOutput()->GetExtent();
    const auto mesh = surface(test::image_of(heights), scheme);
    for (int j = 1; j < 5; ++j) {
      for (int i = 1; i < 5; ++i) {
        const auto c = static_cast<Index>(std::lround((i - origin[0]) / h)) - e[0];
        const auto r = static_cast<Index>(std::lround((j - origin[1]) / h)) - e[2];
        const double dx = (limit(r, c + 1) - limit(r, c - 1)) / (2 * h);
        const double dy = (limit(r + 1, c) - limit(r - 1, c)) / (2 * h);
        const auto n = normal(mesh, 6 * j + i);
        EXPECT_NEAR(-n[0] / n[2], dx, 0.02 * (std::abs(dx) + 300)) << scheme;
        EXPECT_NEAR(-n[1] / n[2], dy, 0.02 * (std::abs(dy) + 300)) << scheme;
      }
    }
  }
}

TEST(surface, limit_points_are_those_of_the_limit_stencil) {
  const Grid<double> heights = test::dyadic_heights({5, 5});
  const auto mesh = surface(test::image_of(heights), "b-spline:degree=3", true);
  // (1, 4, 1)/6 along both axes.
  double sum = 0;
  for (int dr = -1; dr <= 1; ++dr)
    for (int dc = -1; dc <= 1; ++dc)
      sum += heights(2 + dr, 2 + dc) * (dr == 0 ? 4 : 1) * (dc == 0 ? 4 : 1) / 36.0;
  EXPECT_NEAR(mesh->GetPoint(12)[2], sum, 1e-11);
  EXPECT_NEAR(mesh->GetPointData()->GetArray("height")->GetTuple1(12), sum, 1e-11);
}

TEST(surface, missing_heights_leave_holes_or_are_hidden) {
  Grid<double> heights = test::random_heights({5, 6});
  heights(2, 2) = NAN;
  const auto image = test::image_of(heights);
  test::hide(image, {0});
  const auto dropped = surface(image, "gentle");
  EXPECT_EQ(dropped->GetNumberOfCells(), 20 - 4 - 1);
  EXPECT_EQ(dropped->GetNumberOfPoints(), 30 - 2);
  double bounds[6];
  dropped->GetBounds(bounds);
  EXPECT_TRUE(std::isfinite(bounds[4]) && std::isfinite(bounds[5]));
  const auto blanked = surface(image, "gentle", false, vtkAreteSurface::BLANK);
  EXPECT_EQ(blanked->GetNumberOfPoints(), 30);
  ASSERT_EQ(blanked->GetNumberOfCells(), 20);
  int hidden_points = 0;
  int hidden_cells = 0;
  for (vtkIdType i = 0; i < 30; ++i)
    if (blanked->GetPointGhostArray()->GetValue(i) & vtkDataSetAttributes::HIDDENPOINT)
      ++hidden_points;
  for (vtkIdType i = 0; i < 20; ++i)
    if (blanked->GetCellGhostArray()->GetValue(i) & vtkDataSetAttributes::HIDDENCELL)
      ++hidden_cells;
  EXPECT_EQ(hidden_points, 2);
  EXPECT_EQ(hidden_cells, 5);
}

TEST(surface, data_are_passed_on_and_textures_cover_the_pixels) {
  const auto image = test::image_of(test::random_heights({3, 4}));
  const vtkNew<vtkIntArray> kinds;
  kinds->SetName("kind");
  for (int i = 0; i < 12; ++i) kinds->InsertNextValue(i);
  image->GetPointData()->AddArray(kinds);
  const vtkNew<vtkIntArray> plots;
  plots->SetName("plot");
  for (int i = 0; i < 6; ++i) plots->InsertNextValue(i);
  image->GetCellData()->AddArray(plots);
  const auto mesh = surface(image, "chaikin");
  for (vtkIdType i = 0; i < 12; ++i)
    EXPECT_EQ(mesh->GetPointData()->GetArray("kind")->GetTuple1(i), static_cast<double>(i));
  for (vtkIdType i = 0; i < 6; ++i)
    EXPECT_EQ(mesh->GetCellData()->GetArray("plot")->GetTuple1(i), static_cast<double>(i));
  double t[2];
  mesh->GetPointData()->GetTCoords()->GetTuple(6, t);
  EXPECT_FLOAT_EQ(static_cast<float>(t[0]), 2.5F / 4);
  EXPECT_FLOAT_EQ(static_cast<float>(t[1]), 1.5F / 3);
}

TEST(surface, pieces_have_the_very_points_normals_and_quads_of_the_whole) {
  Grid<double> heights = test::random_heights({17, 23});
  heights(8, 9) = NAN;
  const auto image = test::image_of(heights, {3, -5});
  for (const bool limit : {false, true}) {
    const vtkNew<test::ExactSource> source;
    source->SetImage(image);
    const vtkNew<vtkAreteSurface> filter;
    filter->SetInputConnection(source->GetOutputPort());
    filter->SetScheme("b-spline:degree=5");
    filter->SetLimit(limit);
    filter->Update();
    // Points by place, with everything that belongs to them.
    using Numbers = std::array<double, 6>;
    const auto numbers = [&](vtkIdType point) {
      vtkPolyData* mesh = filter->GetPolyDataOutput();
      const auto n = normal(mesh, point);
      double t[2];
      mesh->GetPointData()->GetTCoords()->GetTuple(point, t);
      return Numbers{mesh->GetPoint(point)[2], n[0], n[1], n[2], t[0], t[1]};
    };
    std::map<std::pair<double, double>, Numbers> whole;
    const auto place = [&](vtkIdType point) {
      const double* p = filter->GetPolyDataOutput()->GetPoint(point);
      return std::pair(p[0], p[1]);
    };
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
      whole[place(i)] = numbers(i);
    const vtkIdType cells = filter->GetOutput()->GetNumberOfCells();
    vtkIdType in_pieces = 0;
    for (int piece = 0; piece < 6; ++piece) {
      source->Modified();  // or what it holds already would do
      filter->UpdatePiece(piece, 6, 0);
      in_pieces += filter->GetOutput()->GetNumberOfCells();
      for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfPoints(); ++i)
        EXPECT_EQ(numbers(i), whole.at(place(i)));
    }
    EXPECT_EQ(in_pieces, cells);
  }
}

TEST(surface, what_cannot_be_done_is_an_error) {
  const auto error_of = [](vtkImageData* image, int boundary) {
    const vtkNew<vtkAreteSurface> filter;
    filter->SetInputData(image);
    filter->SetBoundary(boundary);
    const vtkNew<test::Errors> errors;
    errors->watch(filter);
    errors->watch(filter->GetExecutive());
    filter->Update();
    EXPECT_EQ(filter->GetOutput()->GetNumberOfPoints(), 0);
    return errors->messages.empty() ? std::string() : errors->messages.front();
  };
  const vtkNew<vtkImageData> bare;
  bare->SetDimensions(3, 3, 1);
  EXPECT_NE(error_of(bare, 0).find("heights"), std::string::npos);
  const vtkNew<vtkImageData> volume;
  volume->SetDimensions(3, 3, 2);
  volume->AllocateScalars(VTK_DOUBLE, 1);
  EXPECT_NE(error_of(volume, 0).find("slices"), std::string::npos);
  const auto good = test::image_of(Grid<double>({3, 3}));
  EXPECT_NE(error_of(good, vtkAreteFilter::NONE).find("none"), std::string::npos);
  const vtkNew<vtkImageData> empty;
  EXPECT_EQ(error_of(empty, 0), "");
}

}  // namespace
}  // namespace arete

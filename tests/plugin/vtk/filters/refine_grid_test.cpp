// SPDX-License-Identifier: MIT
// vtkAreteRefineGrid on structured grids.
#include <gtest/gtest.h>
#include <vtkAreteRefineGrid.h>
#include <vtkCellData.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <cstring>

#include "arete/analysis/polynomial.h"
#include "arete/refine/refiner.h"
#include "plugin/vtk/filters/images.h"
#include "plugin/vtk/filters/quad_meshes.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

// A bent surface: no coordinate is a plane.
std::array<Grid<double>, 3> bent(Extent extent) {
  return {test::random_heights(extent, 1), test::random_heights(extent, 2),
          test::random_heights(extent, 3)};
}

vtkSmartPointer<vtkAreteRefineGrid> refined(vtkDataSet* grid, const std::string& scheme,
                                            int levels) {
  auto refine = vtkSmartPointer<vtkAreteRefineGrid>::New();
  refine->SetInputData(grid);
  refine->SetScheme(scheme.c_str());
  refine->SetLevels(levels);
  refine->Update();
  return refine;
}

TEST(refine_grid, every_coordinate_is_refined_as_the_library_does_it) {
  const auto planes = bent({7, 9});
  for (const Scheme& scheme : test::sample_schemes()) {
    const auto filter = refined(test::structured_grid(planes), scheme.text(), 1);
    vtkStructuredGrid* fine = filter->GetStructuredGridOutput();
    for (std::size_t c = 0; c < 3; ++c) {
      const Grid<double> expected = refine(planes[c], scheme);
      ASSERT_EQ(fine->GetNumberOfPoints(), static_cast<vtkIdType>(expected.samples().size()));
      for (std::size_t i = 0; i < expected.samples().size(); ++i)
        ASSERT_EQ(fine->GetPoint(static_cast<vtkIdType>(i))[c], expected.samples()[i])
            << scheme.text();
    }
  }
}

TEST(refine_grid, pieces_equal_the_whole_to_the_last_bit) {
  const auto grid = test::structured_grid(bent({19, 23}), {5, -3});
  const vtkNew<vtkDoubleArray> values;
  values->SetName("value");
  values->SetNumberOfTuples(grid->GetNumberOfPoints());
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
    values->SetValue(i, static_cast<double>((i * i) % 97) / 7);
  grid->GetPointData()->AddArray(values);
  for (const char* scheme : {"gentle", "chaikin", "ternary-four-point"}) {
    for (const int rule : {vtkAreteRefineGrid::SCHEME, vtkAreteRefineGrid::LINEAR}) {
      for (const int boundary : {vtkAreteFilter::EXTRAPOLATE, vtkAreteFilter::PERIODIC}) {
        const vtkNew<vtkAreteRefineGrid> refine;
        refine->SetInputData(grid);
        refine->SetScheme(scheme);
        refine->SetLevels(2);
        refine->SetPointData(rule);
        refine->SetBoundary(boundary);
        refine->Update();
        const vtkNew<vtkStructuredGrid> whole;
        whole->DeepCopy(refine->GetOutput());
        const int* w = whole->GetExtent();
        for (int piece = 0; piece < 5; ++piece) {
          refine->UpdatePiece(piece, 5, 0);
          vtkStructuredGrid* part = refine->GetStructuredGridOutput();
          const int* e = part->GetExtent();
          ASSERT_LT(part->GetNumberOfPoints(), whole->GetNumberOfPoints());
          vtkIdType point = 0;
          for (int j = e[2]; j <= e[3]; ++j) {
            for (int i = e[0]; i <= e[1]; ++i, ++point) {
              const vtkIdType same = (j - w[2]) * (w[1] - w[0] + 1) + i - w[0];
              double p[3], q[3];
              part->GetPoint(point, p);
              whole->GetPoint(same, q);
              ASSERT_EQ(std::memcmp(p, q, sizeof p), 0);
              ASSERT_EQ(part->GetPointData()->GetArray("value")->GetTuple1(point),
                        whole->GetPointData()->GetArray("value")->GetTuple1(same));
            }
          }
        }
      }
    }
  }
}

TEST(refine_grid, linear_point_data_stay_between_their_neighbours_and_keep_planes) {
  const auto grid = test::structured_grid(test::terrain(Grid<double>({5, 6})));
  const vtkNew<vtkDoubleArray> step;
  step->SetName("step");
  const vtkNew<vtkDoubleArray> ramp;
  ramp->SetName("ramp");
  for (int r = 0; r < 5; ++r) {
    for (int c = 0; c < 6; ++c) {
      step->InsertNextValue(c < 3 ? 0 : 1);
      ramp->InsertNextValue(2 * c - 3 * r);
    }
  }
  grid->GetPointData()->AddArray(step);
  grid->GetPointData()->AddArray(ramp);
  for (const Scheme& scheme : test::sample_schemes()) {
    if (sum_rules(scheme.mask()) < 2) continue;  // moves planes
    const vtkNew<vtkAreteRefineGrid> refine;
    refine->SetInputData(grid);
    refine->SetScheme(scheme.text().c_str());
    refine->SetPointData(vtkAreteRefineGrid::LINEAR);
    refine->Update();
    vtkStructuredGrid* fine = refine->GetStructuredGridOutput();
    for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i) {
      const double value = fine->GetPointData()->GetArray("step")->GetTuple1(i);
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 1);
      // Points of a plane stay where they are, so they tell where the value belongs.
      EXPECT_NEAR(fine->GetPointData()->GetArray("ramp")->GetTuple1(i),
                  2 * fine->GetPoint(i)[0] + 3 * fine->GetPoint(i)[1], 1e-11)
          << scheme.text();
    }
  }
}

TEST(refine_grid, normals_keep_length_one_and_cells_their_parent) {
  const auto grid = test::structured_grid(test::terrain(Grid<double>({3, 4})));
  const vtkNew<vtkDoubleArray> normals;
  normals->SetName("n");
  normals->SetNumberOfComponents(3);
  for (int i = 0; i < 12; ++i) {
    const double angle = 0.5 * i;
    normals->InsertNextTuple3(std::cos(angle), std::sin(angle), 0);
  }
  grid->GetPointData()->SetNormals(normals);
  const vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  for (int i = 0; i < 6; ++i) numbers->InsertNextValue(i);
  grid->GetCellData()->AddArray(numbers);
  const auto filter = refined(grid, "b-spline:degree=3", 1);
  vtkDataSet* fine = filter->GetOutput();
  ASSERT_NE(fine->GetPointData()->GetNormals(), nullptr);
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i) {
    double n[3];
    fine->GetPointData()->GetNormals()->GetTuple(i, n);
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-12);
  }
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 6; ++i)
      EXPECT_EQ(fine->GetCellData()->GetArray("number")->GetTuple1(6 * j + i), 3 * (j / 2) + i / 2);
}

TEST(refine_grid, hidden_points_stay_hidden_have_a_place_and_bend_nothing) {
  const auto planes = test::terrain(test::plane<double>({8, 9}, 5, 1, 2));
  const auto grid = test::structured_grid(planes);
  grid->GetPoints()->SetPoint(40, 4, -4, -9999);
  grid->BlankPoint(40);
  const auto filter = refined(grid, "gentle", 2);
  vtkStructuredGrid* fine = filter->GetStructuredGridOutput();
  int hidden = 0;
  for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i) {
    double p[3];
    fine->GetPoint(i, p);
    if (fine->IsPointVisible(i)) {
      EXPECT_NEAR(p[2], 5 - p[1] + 2 * p[0], 1e-10);
    } else {
      ++hidden;
      EXPECT_TRUE(std::isfinite(p[2]));
    }
  }
  EXPECT_EQ(hidden, 7 * 7);
}

TEST(refine_grid, empty_and_one_row) {
  const vtkNew<vtkStructuredGrid> empty;
  EXPECT_EQ(refined(empty, "gentle", 1)->GetOutput()->GetNumberOfPoints(), 0);
  const auto row = refined(test::structured_grid(bent({1, 5})), "four-point", 1);
  EXPECT_EQ(row->GetOutput()->GetNumberOfPoints(), 9);
}

}  // namespace
}  // namespace arete

// SPDX-License-Identifier: MIT
// vtkAreteRefineGrid on polygons: whatever the numbering, the surface is that of the grid.
#include <gtest/gtest.h>
#include <vtkAppendPolyData.h>
#include <vtkAreteRefineGrid.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>
#include <vtkTriangle.h>

#include <map>
#include <tuple>

#include "arete/refine/refiner.h"
#include "plugin/vtk/filters/images.h"
#include "plugin/vtk/filters/quad_meshes.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

using test::Faces;

vtkSmartPointer<vtkPolyData> refined(vtkPolyData* mesh, const char* scheme, int levels) {
  const vtkNew<vtkAreteRefineGrid> refine;
  refine->SetInputData(mesh);
  refine->SetScheme(scheme);
  refine->SetLevels(levels);
  refine->Update();
  return refine->GetPolyDataOutput();
}

// Twice the area of the shadow of all polygons on the plane; negative where they look down.
double shadow(vtkPolyData* mesh) {
  double sum = 0;
  for (vtkIdType f = 0; f < mesh->GetNumberOfCells(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetCellPoints(f, size, ids);
    for (vtkIdType i = 0; i < size; ++i) {
      double p[3], q[3];
      mesh->GetPoint(ids[i], p);
      mesh->GetPoint(ids[(i + 1) % size], q);
      sum += p[0] * q[1] - p[1] * q[0];
    }
  }
  return sum;
}

TEST(refine_polygons, quads_in_any_order_give_the_refined_grid) {
  const Grid<double> heights = test::random_heights({6, 7});
  for (const char* scheme : {"gentle", "three-point", "chaikin", "ternary-four-point"}) {
    const Grid<double> fine = refine(heights, parse_scheme(scheme));
    for (unsigned seed = 1; seed < 4; ++seed) {
      const auto mesh = test::polygons(test::terrain(heights), Faces::quads, false, seed);
      const auto result = refined(mesh, scheme, 1);
      ASSERT_EQ(result->GetNumberOfPoints(), static_cast<vtkIdType>(fine.samples().size()));
      EXPECT_EQ(result->GetNumberOfCells(), (fine.rows() - 1) * (fine.cols() - 1));
      // Rows run south and columns east, so the order is that of a raster.
      for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
        ASSERT_EQ(result->GetPoint(i)[2], fine.samples()[static_cast<std::size_t>(i)]) << scheme;
      EXPECT_GT(shadow(result), 0) << "polygons look up as those of the input";
    }
  }
}

TEST(refine_polygons, polygons_that_look_down_do_so_afterwards) {
  const auto mesh = test::polygons(test::terrain(test::random_heights({4, 5})), Faces::quads);
  const vtkNew<vtkCellArray> turned;
  for (vtkIdType f = 0; f < mesh->GetNumberOfPolys(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    mesh->GetPolys()->GetCellAtId(f, size, ids);
    std::vector<vtkIdType> face(ids, ids + size);
    std::reverse(face.begin(), face.end());
    turned->InsertNextCell(size, face.data());
  }
  mesh->SetPolys(turned);
  EXPECT_LT(shadow(refined(mesh, "gentle", 1)), 0);
}

TEST(refine_polygons, triangles_are_cut_along_the_diagonal_of_their_parent) {
  const Grid<double> heights = test::random_heights({5, 6});
  for (const Faces kind : {Faces::main_diagonals, Faces::anti_diagonals}) {
    const auto result = refined(test::polygons(test::terrain(heights), kind), "four-point", 1);
    EXPECT_EQ(result->GetNumberOfPoints(), 9 * 11);
    EXPECT_EQ(result->GetNumberOfCells(), 2 * 8 * 10);
    EXPECT_GT(shadow(result), 0);
    int agreeing = 0;
    for (vtkIdType f = 0; f < result->GetNumberOfCells(); ++f) {
      vtkIdType size = 0;
      const vtkIdType* ids = nullptr;
      result->GetCellPoints(f, size, ids);
      ASSERT_EQ(size, 3);
      for (int i = 0; i < 3; ++i) {
        double p[3], q[3];
        result->GetPoint(ids[i], p);
        result->GetPoint(ids[(i + 1) % 3], q);
        // The diagonal: x and y differ. Along the main one they grow against each other (y = -r).
        if (p[0] == q[0] || p[1] == q[1]) continue;
        const bool main = (p[0] < q[0]) == (p[1] > q[1]);
        agreeing += main == (kind == Faces::main_diagonals) ? 1 : 0;
      }
    }
    EXPECT_EQ(agreeing, result->GetNumberOfCells());
  }
}

TEST(refine_polygons, a_tube_stays_closed_and_round) {
  // A regular 12-gon swept along z. An old point moves to (6 + 2 cos 30) / 8 of its radius, a new
  // one lies at cos 15, then (6 + 2 cos 15) / 8 and cos 7.5 of about that.
  std::array<Grid<double>, 3> tube{Grid<double>({4, 12}), Grid<double>({4, 12}),
                                   Grid<double>({4, 12})};
  for (Index r = 0; r < 4; ++r) {
    for (Index c = 0; c < 12; ++c) {
      const double angle = static_cast<double>(c) * M_PI / 6;
      tube[0](r, c) = std::cos(angle);
      tube[1](r, c) = std::sin(angle);
      tube[2](r, c) = static_cast<double>(r);
    }
  }
  const auto result = refined(test::polygons(tube, Faces::quads, true), "b-spline:degree=3", 2);
  EXPECT_EQ(result->GetNumberOfPoints(), 13 * 48);
  EXPECT_EQ(result->GetNumberOfCells(), 12 * 48);
  std::vector<int> uses(static_cast<std::size_t>(result->GetNumberOfPoints()));
  for (vtkIdType f = 0; f < result->GetNumberOfCells(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    result->GetCellPoints(f, size, ids);
    for (vtkIdType i = 0; i < size; ++i) ++uses[static_cast<std::size_t>(ids[i])];
  }
  int rim = 0;
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i) {
    double p[3];
    result->GetPoint(i, p);
    const bool at_rim = p[2] < 1e-9 || p[2] > 3 - 1e-9;
    EXPECT_EQ(uses[static_cast<std::size_t>(i)], at_rim ? 2 : 4);
    rim += at_rim ? 1 : 0;
    EXPECT_NEAR(std::hypot(p[0], p[1]), 0.958, 0.003);
  }
  EXPECT_EQ(rim, 2 * 48);
}

TEST(refine_polygons, several_parts_keep_their_data_apart) {
  const auto first = test::polygons(test::terrain(Grid<double>({3, 3}, 1)), Faces::quads);
  const auto second = test::polygons(test::terrain(Grid<double>({4, 3}, 9)), Faces::quads);
  for (vtkPolyData* mesh : {first.Get(), second.Get()}) {
    const vtkNew<vtkDoubleArray> values;
    values->SetName("value");
    values->SetNumberOfTuples(mesh->GetNumberOfPoints());
    values->Fill(mesh == first.Get() ? 10 : 20);
    mesh->GetPointData()->SetScalars(values);
    const vtkNew<vtkIntArray> numbers;
    numbers->SetName("number");
    for (int i = 0; i < mesh->GetNumberOfCells(); ++i)
      numbers->InsertNextValue(mesh == first.Get() ? 1 : 2);
    mesh->GetCellData()->AddArray(numbers);
  }
  const vtkNew<vtkAppendPolyData> both;
  both->AddInputData(first);
  both->AddInputData(second);
  both->Update();
  const auto result = refined(both->GetOutput(), "gentle", 1);
  ASSERT_EQ(result->GetNumberOfPoints(), 25 + 35);
  ASSERT_NE(result->GetPointData()->GetScalars(), nullptr);
  for (vtkIdType i = 0; i < result->GetNumberOfPoints(); ++i)
    EXPECT_NEAR(result->GetPointData()->GetScalars()->GetTuple1(i),
                result->GetPoint(i)[2] < 5 ? 10 : 20, 1e-12);
  for (vtkIdType f = 0; f < result->GetNumberOfCells(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    result->GetCellPoints(f, size, ids);
    EXPECT_EQ(result->GetCellData()->GetArray("number")->GetTuple1(f),
              result->GetPoint(ids[0])[2] < 5 ? 1 : 2);
  }
}

TEST(refine_polygons, what_is_no_grid_is_an_error) {
  const auto error_of = [](vtkPolyData* mesh, int boundary = vtkAreteFilter::EXTRAPOLATE) {
    const vtkNew<vtkAreteRefineGrid> refine;
    refine->SetInputData(mesh);
    refine->SetBoundary(boundary);
    const vtkNew<test::Errors> errors;
    errors->watch(refine);
    errors->watch(refine->GetExecutive());
    refine->Update();
    EXPECT_EQ(refine->GetOutput()->GetNumberOfPoints(), 0);
    return errors->messages.empty() ? std::string() : errors->messages.front();
  };
  const auto hole = test::polygons(test::terrain(Grid<double>({5, 5})), Faces::quads);
  hole->BuildLinks();
  const vtkNew<vtkCellArray> fewer;
  for (vtkIdType f = 1; f < hole->GetNumberOfPolys(); ++f) {
    vtkIdType size = 0;
    const vtkIdType* ids = nullptr;
    hole->GetPolys()->GetCellAtId(f, size, ids);
    fewer->InsertNextCell(size, ids);
  }
  hole->SetPolys(fewer);
  EXPECT_FALSE(error_of(hole).empty());

  const auto lines = test::polygons(test::terrain(Grid<double>({3, 3})), Faces::quads);
  lines->SetLines(lines->GetPolys());
  EXPECT_NE(error_of(lines).find("lines"), std::string::npos);

  const auto nan = test::polygons(test::terrain(Grid<double>({3, 3}, NAN)), Faces::quads);
  EXPECT_NE(error_of(nan).find("not finite"), std::string::npos);

  const auto open = test::polygons(test::terrain(Grid<double>({4, 4})), Faces::quads);
  EXPECT_NE(error_of(open, vtkAreteFilter::PERIODIC).find("periodic"), std::string::npos);

  const vtkNew<vtkPolyData> empty;
  EXPECT_EQ(error_of(empty), "");
}

TEST(refine_polygons, all_pieces_but_the_first_are_empty) {
  const vtkNew<vtkAreteRefineGrid> refine;
  refine->SetInputData(test::polygons(test::terrain(Grid<double>({4, 4})), Faces::quads));
  refine->UpdatePiece(1, 3, 0);
  EXPECT_EQ(refine->GetOutput()->GetNumberOfPoints(), 0);
  refine->UpdatePiece(0, 3, 0);
  EXPECT_EQ(refine->GetOutput()->GetNumberOfPoints(), 49);
}

}  // namespace
}  // namespace arete

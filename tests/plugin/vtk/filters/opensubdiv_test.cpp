// SPDX-License-Identifier: MIT
// Catmull-Clark by OpenSubdiv against the filters with b-spline:degree=3. Coordinates are dyadic,
// so equal means equal.
#include <gtest/gtest.h>
#include <vtkAreteRefineGrid.h>
#include <vtkAreteRefineImage.h>
#include <vtkPoints.h>
#include <vtkStructuredGrid.h>

#include "arete/opensubdiv/catmull_clark.h"
#include "plugin/vtk/filters/images.h"
#include "plugin/vtk/filters/quad_meshes.h"
#include "support/fields.h"

namespace arete {
namespace {

using opensubdiv::catmull_clark;
using opensubdiv::CornerRule;

constexpr Extent sizes[]{{2, 2}, {3, 5}, {17, 9}, {33, 33}};

TEST(filters_opensubdiv, a_refined_image_is_catmull_clark) {
  for (const Extent extent : sizes) {
    const Grid<double> heights = test::dyadic_heights(extent, 3);
    for (int levels = 1; levels <= 3; ++levels) {
      const vtkNew<vtkAreteRefineImage> refine;
      refine->SetInputData(test::image_of(heights));
      refine->SetScheme("b-spline:degree=3");
      refine->SetLevels(levels);
      refine->Update();
      EXPECT_TRUE(test::same_bits(test::grid_of(refine->GetOutput()),
                                  catmull_clark(heights, levels, CornerRule::sharp)));
    }
  }
}

TEST(filters_opensubdiv, a_refined_structured_grid_is_catmull_clark_in_all_coordinates) {
  for (const Extent extent : sizes) {
    const std::array<Grid<double>, 3> planes{test::dyadic_heights(extent, 3),
                                             test::dyadic_heights(extent, 4),
                                             test::dyadic_heights(extent, 5)};
    const vtkNew<vtkAreteRefineGrid> refine;
    refine->SetInputData(test::structured_grid(planes));
    refine->SetScheme("b-spline:degree=3");
    refine->SetLevels(2);
    refine->Update();
    const auto expected =
        catmull_clark({planes[0].view(), planes[1].view(), planes[2].view()}, 2, CornerRule::sharp);
    vtkStructuredGrid* fine = refine->GetStructuredGridOutput();
    ASSERT_EQ(fine->GetNumberOfPoints(), static_cast<vtkIdType>(expected[0].samples().size()));
    for (std::size_t i = 0; i < expected[0].samples().size(); ++i)
      for (int c = 0; c < 3; ++c)
        ASSERT_EQ(fine->GetPoint(static_cast<vtkIdType>(i))[c],
                  expected[static_cast<std::size_t>(c)].samples()[i]);
  }
}

}  // namespace
}  // namespace arete

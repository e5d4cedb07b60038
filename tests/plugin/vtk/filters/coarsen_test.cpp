// SPDX-License-Identifier: MIT
// vtkAreteCoarsen and vtkAreteRestore.
#include <gtest/gtest.h>
#include <vtkAreteCoarsen.h>
#include <vtkAreteRefineImage.h>
#include <vtkAreteRestore.h>
#include <vtkExecutive.h>
#include <vtkFieldData.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>

#include "plugin/vtk/filters/images.h"
#include "support/fields.h"
#include "support/schemes.h"
#include "support/temporary_folder.h"

namespace arete {
namespace {

vtkSmartPointer<vtkImageData> placed(const Grid<double>& heights) {
  const auto image = test::image_of(heights, {-4, 7});
  image->SetOrigin(100, 200, 5);
  image->SetSpacing(30, 20, 1);
  return image;
}

double largest_difference(const Grid<double>& a, const Grid<double>& b) {
  EXPECT_EQ(a.extent(), b.extent());
  double largest = 0;
  for (std::size_t i = 0; i < a.samples().size(); ++i) {
    EXPECT_EQ(std::isnan(a.samples()[i]), std::isnan(b.samples()[i]));
    if (!std::isnan(a.samples()[i]))
      largest = std::max(largest, std::abs(a.samples()[i] - b.samples()[i]));
  }
  return largest;
}

TEST(coarsen, restoring_gives_the_image_back_where_it_was) {
  Grid<double> heights = test::random_heights({37, 29});
  heights(5, 6) = NAN;
  for (const char* scheme : {"chaikin", "four-point", "b-spline:degree=3", "ternary-four-point"}) {
    const vtkNew<vtkAreteCoarsen> coarsen;
    coarsen->SetInputData(placed(heights));
    coarsen->SetScheme(scheme);
    coarsen->SetLevels(2);
    coarsen->Update();
    EXPECT_LT(coarsen->GetOutput()->GetNumberOfPoints(), heights.rows() * heights.cols() / 3);
    const vtkNew<vtkAreteRestore> restore;
    restore->SetInputConnection(coarsen->GetOutputPort());
    restore->Update();
    vtkImageData* back = restore->GetOutput();
    EXPECT_LT(largest_difference(test::grid_of(back), heights), 1e-9) << scheme;
    EXPECT_EQ(back->GetExtent()[0], -4);
    EXPECT_EQ(back->GetExtent()[2], 7);
    EXPECT_EQ(back->GetOrigin()[1], 200);
    EXPECT_EQ(back->GetSpacing()[0], 30);
    EXPECT_EQ(back->GetFieldData()->GetArray("AreteDetails"), nullptr);
  }
}

TEST(coarsen, what_refinement_made_comes_back_and_lies_where_it_lay) {
  for (const char* scheme : {"chaikin", "four-point", "b-spline:degree=3"}) {
    const Grid<double> heights = test::dyadic_heights({8, 9});
    const vtkNew<vtkAreteRefineImage> refine;
    refine->SetInputData(placed(heights));
    refine->SetScheme(scheme);
    const vtkNew<vtkAreteCoarsen> coarsen;
    coarsen->SetInputConnection(refine->GetOutputPort());
    coarsen->SetScheme(scheme);
    coarsen->Update();
    vtkImageData* coarse = coarsen->GetOutput();
    EXPECT_LT(largest_difference(test::grid_of(coarse), heights), 1e-9) << scheme;
    const auto input = placed(heights);
    for (const vtkIdType point : {0, 71})
      for (int a = 0; a < 3; ++a)
        EXPECT_NEAR(coarse->GetPoint(point)[a], input->GetPoint(point)[a], 1e-9) << scheme;
  }
}

TEST(coarsen, details_survive_a_file_and_hidden_points_are_kept) {
  const test::TemporaryFolder folder;
  const Grid<double> heights = test::random_heights({20, 21});
  const auto image = placed(heights);
  test::hide(image, {50, 51, 52});
  const vtkNew<vtkAreteCoarsen> coarsen;
  coarsen->SetInputData(image);
  coarsen->SetScheme("chaikin");
  const vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetInputConnection(coarsen->GetOutputPort());
  writer->SetFileName((folder.path() / "coarse.vti").c_str());
  ASSERT_EQ(writer->Write(), 1);
  const vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(writer->GetFileName());
  const vtkNew<vtkAreteRestore> restore;
  restore->SetInputConnection(reader->GetOutputPort());
  restore->Update();
  vtkImageData* back = restore->GetOutput();
  ASSERT_NE(back->GetPointGhostArray(), nullptr);
  for (vtkIdType i = 0; i < back->GetNumberOfPoints(); ++i) {
    const bool hidden = i >= 50 && i <= 52;
    EXPECT_EQ(back->GetPointGhostArray()->GetValue(i) != 0, hidden);
    if (!hidden) {
      EXPECT_NEAR(back->GetPointData()->GetArray("height")->GetTuple1(i),
                  heights.samples()[static_cast<std::size_t>(i)], 1e-9);
    }
  }
}

TEST(coarsen, a_threshold_makes_details_smaller_and_bounds_the_error) {
  const Grid<double> heights = test::random_heights({40, 40});
  const auto bytes_and_error = [&](double threshold) {
    const vtkNew<vtkAreteCoarsen> coarsen;
    coarsen->SetInputData(test::image_of(heights));
    coarsen->SetScheme("four-point");
    coarsen->SetThreshold(threshold);
    const vtkNew<vtkAreteRestore> restore;
    restore->SetInputConnection(coarsen->GetOutputPort());
    restore->Update();
    const auto bytes =
        coarsen->GetOutput()->GetFieldData()->GetArray("AreteDetails")->GetNumberOfValues();
    return std::pair(static_cast<double>(bytes),
                     largest_difference(test::grid_of(restore->GetOutput()), heights));
  };
  const auto [all, exact] = bytes_and_error(0);
  const auto [fewer, rough] = bytes_and_error(20);
  EXPECT_LT(exact, 1e-9);
  EXPECT_LT(fewer, 0.7 * all);
  EXPECT_GT(rough, 1);
  EXPECT_LT(rough, 100);
}

TEST(coarsen, changed_coarse_values_are_refused_unless_meant) {
  const vtkNew<vtkAreteCoarsen> coarsen;
  coarsen->SetInputData(test::image_of(test::random_heights({20, 20})));
  coarsen->SetScheme("four-point");
  coarsen->Update();
  const vtkNew<vtkImageData> changed;
  changed->DeepCopy(coarsen->GetOutput());
  changed->GetPointData()->GetArray("height")->SetTuple1(44, 1e4);
  const vtkNew<vtkAreteRestore> restore;
  restore->SetInputData(changed);
  const vtkNew<test::Errors> errors;
  errors->watch(restore);
  errors->watch(restore->GetExecutive());
  restore->Update();
  EXPECT_TRUE(errors->mention("Edited"));
  EXPECT_EQ(restore->GetOutput()->GetNumberOfPoints(), 0);
  restore->EditedOn();
  restore->Update();
  double range[2];
  restore->GetOutput()->GetPointData()->GetArray("height")->GetRange(range);
  EXPECT_GT(range[1], 5e3);
}

TEST(coarsen, what_cannot_be_done_is_an_error) {
  const auto error_of = [](auto&& configure) {
    const vtkNew<vtkAreteCoarsen> coarsen;
    coarsen->SetInputData(test::image_of(Grid<double>({9, 9})));
    configure(coarsen.Get());
    const vtkNew<test::Errors> errors;
    errors->watch(coarsen);
    errors->watch(coarsen->GetExecutive());
    coarsen->Update();
    EXPECT_EQ(coarsen->GetOutput()->GetNumberOfPoints(), 0);
    return errors->messages.empty() ? std::string() : errors->messages.front();
  };
  EXPECT_NE(error_of([](auto* c) { c->SetSchemeY("chaikin"); }).find("SchemeY"), std::string::npos);
  EXPECT_NE(error_of([](auto* c) { c->SetBoundary(vtkAreteFilter::NONE); }).find("none"),
            std::string::npos);
  EXPECT_FALSE(error_of([](auto* c) {
                 c->SetMode(vtkAreteCoarsen::LOCAL);
                 c->SetScheme("b-spline:degree=4");
               }).empty());
  const vtkNew<vtkAreteRestore> restore;
  restore->SetInputData(test::image_of(Grid<double>({3, 3})));
  const vtkNew<test::Errors> errors;
  errors->watch(restore);
  errors->watch(restore->GetExecutive());
  restore->Update();
  EXPECT_TRUE(errors->mention("AreteDetails"));
}

TEST(coarsen, an_empty_image_stays_empty) {
  const vtkNew<vtkImageData> empty;
  const vtkNew<vtkAreteCoarsen> coarsen;
  coarsen->SetInputData(empty);
  const vtkNew<vtkAreteRestore> restore;
  restore->SetInputConnection(coarsen->GetOutputPort());
  restore->Update();
  EXPECT_EQ(restore->GetOutput()->GetNumberOfPoints(), 0);
}

}  // namespace
}  // namespace arete

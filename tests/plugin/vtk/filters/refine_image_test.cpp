// SPDX-License-Identifier: MIT
// vtkAreteRefineImage: values against the library, places, types, missing points, odd inputs.
#include <gtest/gtest.h>
#include <vtkAreteRefineImage.h>
#include <vtkAreteScheme.h>
#include <vtkCallbackCommand.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkIntArray.h>
#include <vtkLongLongArray.h>
#include <vtkShortArray.h>
#include <vtkStringArray.h>
#include <vtkTransform.h>

#include <cmath>
#include <sstream>

#include "arete/analysis/polynomial.h"
#include "arete/refine/refiner.h"
#include "plugin/vtk/filters/images.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

vtkSmartPointer<vtkAreteRefineImage> refined(vtkImageData* image, const std::string& scheme,
                                             int levels) {
  auto refine = vtkSmartPointer<vtkAreteRefineImage>::New();
  refine->SetInputData(image);
  refine->SetScheme(scheme.c_str());
  refine->SetLevels(levels);
  refine->Update();
  return refine;
}

Grid<double> by_library(const Grid<double>& heights, const char* scheme) {
  return refine(heights, parse_scheme(scheme));
}

TEST(refine_image, gives_the_numbers_of_the_library) {
  const Grid<double> heights = test::random_heights({9, 12});
  for (const Scheme& scheme : test::sample_schemes()) {
    const int levels = scheme.mask().arity() > 3 ? 1 : 2;
    RefineOptions options;
    options.levels = levels;
    const auto filter = refined(test::image_of(heights), scheme.text(), levels);
    EXPECT_TRUE(
        test::same_bits(test::grid_of(filter->GetOutput()), refine(heights, scheme, options)))
        << scheme.text();
  }
}

// Heights that say where they are must still say so afterwards.
TEST(refine_image, what_is_linear_in_space_stays_where_it_is) {
  const double direction[9]{0.8, -0.6, 0, 0.6, 0.8, 0, 0, 0, 1};
  for (const Scheme& scheme : test::sample_schemes()) {
    if (sum_rules(scheme.mask()) < 2) continue;  // reproduces no ramp
    for (const int alignment : {vtkAreteRefineImage::NODES, vtkAreteRefineImage::CELLS}) {
      const auto image = test::image_of(Grid<double>({7, 9}), {-3, 4});
      image->SetOrigin(500, -20, 3);
      image->SetSpacing(2, 0.5, 1);
      image->SetDirectionMatrix(direction);
      for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
        image->GetPointData()->GetScalars()->SetTuple1(
            i, 3 * image->GetPoint(i)[0] - 2 * image->GetPoint(i)[1]);
      const vtkNew<vtkAreteRefineImage> refine;
      refine->SetInputData(image);
      refine->SetScheme(scheme.text().c_str());
      refine->SetAlignment(alignment);
      refine->Update();
      vtkImageData* fine = refine->GetOutput();
      ASSERT_GT(fine->GetNumberOfPoints(), image->GetNumberOfPoints());
      for (vtkIdType i = 0; i < fine->GetNumberOfPoints(); ++i)
        ASSERT_NEAR(fine->GetPointData()->GetScalars()->GetTuple1(i),
                    3 * fine->GetPoint(i)[0] - 2 * fine->GetPoint(i)[1], 1e-9)
            << scheme.text() << " at " << i;
    }
  }
}

TEST(refine_image, extents_keep_their_index_and_spacing_is_cut) {
  const auto image = test::image_of(test::random_heights({5, 6}), {-7, 10});
  const auto filter1 = refined(image, "four-point", 3);
  vtkImageData* fine = filter1->GetOutput();
  const int* e = fine->GetExtent();
  EXPECT_EQ(e[0], -56);
  EXPECT_EQ(e[1], -16);
  EXPECT_EQ(e[2], 80);
  EXPECT_EQ(e[3], 112);
  EXPECT_EQ(fine->GetSpacing()[0], 0.125);
  EXPECT_EQ(fine->GetOrigin()[0], 0);
  // Chaikin moves the origin by a quarter of a cell at the first level, an eighth at the second.
  const auto filter2 = refined(image, "chaikin", 2);
  vtkImageData* dual = filter2->GetOutput();
  EXPECT_EQ(dual->GetOrigin()[0] + dual->GetSpacing()[0] * dual->GetExtent()[0], -7 + 0.125);
}

TEST(refine_image, level_zero_is_the_input) {
  const Grid<double> heights = test::random_heights({5, 6});
  const auto filter = refined(test::image_of(heights, {2, 3}), "craggy", 0);
  EXPECT_TRUE(test::same_bits(test::grid_of(filter->GetOutput()), heights));
  EXPECT_EQ(filter->GetOutput()->GetExtent()[0], 2);
  EXPECT_EQ(filter->GetOutput()->GetExtent()[3], 7);
}

template <class Array>
void check_type(int expected) {
  Grid<double> whole({6, 5});
  for (std::size_t i = 0; i < whole.samples().size(); ++i)
    whole.samples()[i] = static_cast<double>((i * 37) % 101);
  const auto filter = refined(test::image_of<Array>(whole), "four-point", 1);
  vtkDataArray* array = filter->GetOutput()->GetPointData()->GetScalars();
  ASSERT_NE(array, nullptr);
  EXPECT_EQ(array->GetDataType(), expected);
  // Dyadic weights on small integers are exact in either type.
  const Grid<double> exact = refine(whole, parse_scheme("four-point"));
  EXPECT_TRUE(test::same_bits(test::grid_of(filter->GetOutput()), exact));
}

TEST(refine_image, narrow_types_become_float_and_wide_ones_double) {
  check_type<vtkFloatArray>(VTK_FLOAT);
  check_type<vtkShortArray>(VTK_FLOAT);
  check_type<vtkUnsignedCharArray>(VTK_FLOAT);
  check_type<vtkDoubleArray>(VTK_DOUBLE);
  check_type<vtkIntArray>(VTK_DOUBLE);
  check_type<vtkLongLongArray>(VTK_DOUBLE);
  const vtkNew<vtkAreteRefineImage> refine;
  refine->SetInputData(test::image_of<vtkShortArray>(Grid<double>({4, 4})));
  refine->SetOutputScalarType(VTK_DOUBLE);
  refine->Update();
  EXPECT_EQ(refine->GetOutput()->GetPointData()->GetScalars()->GetDataType(), VTK_DOUBLE);
}

TEST(refine_image, all_arrays_components_and_roles_are_kept) {
  const Grid<double> red = test::random_heights({6, 7}, 1);
  const Grid<double> blue = test::random_heights({6, 7}, 2);
  const auto image = test::image_of(red);
  const vtkNew<vtkDoubleArray> colors;
  colors->SetName("colors");
  colors->SetNumberOfComponents(2);
  colors->SetComponentName(0, "r");
  for (std::size_t i = 0; i < red.samples().size(); ++i)
    colors->InsertNextTuple2(red.samples()[i], blue.samples()[i]);
  image->GetPointData()->AddArray(colors);
  const vtkNew<vtkStringArray> names;
  names->SetName("names");
  names->SetNumberOfTuples(image->GetNumberOfPoints());
  image->GetPointData()->AddArray(names);
  const vtkNew<vtkIntArray> ids;
  ids->SetName("ids");
  ids->SetNumberOfTuples(image->GetNumberOfPoints());
  ids->Fill(5);
  image->GetPointData()->SetGlobalIds(ids);

  const auto filter = refined(image, "gentle", 2);
  vtkPointData* data = filter->GetOutput()->GetPointData();
  EXPECT_STREQ(data->GetScalars()->GetName(), "height");
  EXPECT_STREQ(data->GetArray("colors")->GetComponentName(0), "r");
  EXPECT_EQ(data->GetNumberOfArrays(), 2) << "neither ids nor texts can be refined";
  RefineOptions options;
  options.levels = 2;
  const Scheme gentle = parse_scheme("gentle");
  EXPECT_TRUE(test::same_bits(test::grid_of(filter->GetOutput(), "colors", 0),
                              refine(red, gentle, options)));
  EXPECT_TRUE(test::same_bits(test::grid_of(filter->GetOutput(), "colors", 1),
                              refine(blue, gentle, options)));
}

TEST(refine_image, cells_take_the_data_of_their_parent) {
  const auto image = test::image_of(Grid<double>({3, 4}));
  const vtkNew<vtkIntArray> numbers;
  numbers->SetName("number");
  for (int i = 0; i < 6; ++i) numbers->InsertNextValue(i);
  image->GetCellData()->AddArray(numbers);
  const auto filter3 = refined(image, "four-point", 2);
  vtkImageData* fine = filter3->GetOutput();
  auto* result = vtkIntArray::SafeDownCast(fine->GetCellData()->GetArray("number"));
  ASSERT_NE(result, nullptr);
  ASSERT_EQ(result->GetNumberOfTuples(), 12 * 8);
  for (int j = 0; j < 8; ++j)
    for (int i = 0; i < 12; ++i) EXPECT_EQ(result->GetValue(12 * j + i), 3 * (j / 4) + i / 4);
}

TEST(refine_image, hidden_points_and_nan_are_missing_by_the_rule_of_the_library) {
  Grid<double> heights = test::random_heights({9, 10});
  const auto image = test::image_of(heights);
  image->GetPointData()->GetScalars()->SetTuple1(34, -32768);  // whatever stands at a hidden point
  test::hide(image, {34, 77});
  heights.samples()[34] = heights.samples()[77] = NAN;
  RefineOptions options;
  options.levels = 2;
  const Grid<double> expected = refine(heights, parse_scheme("gentle"), options);
  const auto filter = refined(image, "gentle", 2);
  vtkImageData* fine = filter->GetOutput();
  const Grid<double> values = test::grid_of(fine);
  vtkUnsignedCharArray* flags = fine->GetPointGhostArray();
  ASSERT_NE(flags, nullptr);
  int hidden = 0;
  for (std::size_t i = 0; i < expected.samples().size(); ++i) {
    const bool missing = std::isnan(expected.samples()[i]);
    EXPECT_EQ(std::isnan(values.samples()[i]), missing);
    if (!missing) {
      EXPECT_EQ(values.samples()[i], expected.samples()[i]);
    }
    EXPECT_EQ(flags->GetValue(static_cast<vtkIdType>(i)),
              missing ? vtkDataSetAttributes::HIDDENPOINT : 0);
    hidden += missing ? 1 : 0;
  }
  EXPECT_GT(hidden, 20);
}

TEST(refine_image, one_row_one_point_and_nothing) {
  const auto row = refined(test::image_of(test::random_heights({1, 9})), "four-point", 2);
  EXPECT_EQ(row->GetOutput()->GetDimensions()[0], 33);
  EXPECT_EQ(row->GetOutput()->GetDimensions()[1], 1);
  const auto column = refined(test::image_of(test::random_heights({9, 1})), "chaikin", 1);
  EXPECT_EQ(column->GetOutput()->GetDimensions()[0], 1);
  EXPECT_EQ(column->GetOutput()->GetDimensions()[1], 16);
  const Grid<double> one({1, 1}, 7);
  EXPECT_TRUE(
      test::same_bits(test::grid_of(refined(test::image_of(one), "gentle", 3)->GetOutput()), one));

  const vtkNew<vtkImageData> empty;
  EXPECT_EQ(refined(empty, "gentle", 2)->GetOutput()->GetNumberOfPoints(), 0);
  // Points without any array.
  const vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 3, 1);
  EXPECT_EQ(refined(bare, "four-point", 1)->GetOutput()->GetNumberOfPoints(), 35);
}

TEST(refine_image, slices_are_refined_one_by_one) {
  const vtkNew<vtkImageData> volume;
  volume->SetExtent(0, 4, 0, 3, -1, 1);
  volume->AllocateScalars(VTK_DOUBLE, 1);
  const Grid<double> heights = test::random_heights({12, 5});
  std::copy(heights.samples().begin(), heights.samples().end(),
            static_cast<double*>(volume->GetScalarPointer()));
  const auto filter = refined(volume, "gentle", 1);
  vtkImageData* fine = filter->GetOutput();
  EXPECT_EQ(fine->GetExtent()[4], -1);
  EXPECT_EQ(fine->GetDimensions()[2], 3);
  for (int k = 0; k < 3; ++k) {
    Grid<double> slice({4, 5});
    std::copy_n(heights.row(4 * k), 20, slice.row(0));
    const Grid<double> expected = refine(slice, parse_scheme("gentle"));
    EXPECT_EQ(std::memcmp(fine->GetScalarPointer(0, 0, k - 1), expected.samples().data(),
                          expected.samples().size() * 8),
              0);
  }
}

TEST(refine_image, limit_values_do_not_depend_on_the_level) {
  const vtkNew<vtkAreteRefineImage> refine;
  refine->SetInputData(test::image_of(test::dyadic_heights({7, 8})));
  refine->SetScheme("b-spline:degree=3");
  refine->LimitOn();
  refine->Update();
  const Grid<double> once = test::grid_of(refine->GetOutput());
  refine->SetLevels(3);
  refine->Update();
  const Grid<double> thrice = test::grid_of(refine->GetOutput());
  for (Index r = 0; r < once.rows(); ++r)
    for (Index c = 0; c < once.cols(); ++c) EXPECT_NEAR(once(r, c), thrice(4 * r, 4 * c), 1e-11);
}

TEST(refine_image, a_scheme_object_goes_before_the_text_and_its_changes_are_seen) {
  const Grid<double> heights = test::random_heights({6, 6});
  const vtkNew<vtkAreteScheme> scheme;
  scheme->SetFamily("four-point");
  const vtkNew<vtkAreteRefineImage> refine;
  refine->SetInputData(test::image_of(heights));
  refine->SetScheme("nonsense");
  refine->SetSchemeObject(scheme);
  refine->Update();
  EXPECT_TRUE(
      test::same_bits(test::grid_of(refine->GetOutput()), by_library(heights, "four-point")));
  scheme->SetParameter("omega", 1.0 / 11);
  refine->Update();
  EXPECT_TRUE(test::same_bits(test::grid_of(refine->GetOutput()),
                              by_library(heights, "four-point:omega=1/11")));
}

TEST(refine_image, what_cannot_be_done_is_an_error_that_says_why) {
  const auto error_of = [](const char* scheme, int boundary, int levels, bool limit) {
    const vtkNew<vtkAreteRefineImage> refine;
    refine->SetInputData(test::image_of(Grid<double>({4, 4})));
    refine->SetScheme(scheme);
    refine->SetBoundary(boundary);
    refine->SetLevels(levels);
    refine->SetLimit(limit);
    const vtkNew<test::Errors> errors;
    errors->watch(refine);
    errors->watch(refine->GetExecutive());
    refine->Update();
    EXPECT_EQ(refine->GetOutput()->GetNumberOfPoints(), 0) << scheme;
    return errors->messages.empty() ? std::string() : errors->messages.front();
  };
  const auto says = [](const std::string& text, const char* part) {
    EXPECT_NE(text.find(part), std::string::npos) << text;
  };
  says(error_of("gentel", vtkAreteFilter::EXTRAPOLATE, 1, false), "gentle");
  says(error_of("four-point:omega=x", vtkAreteFilter::EXTRAPOLATE, 1, false), "omega");
  says(error_of("dubuc-deslauriers:points=8", vtkAreteFilter::NONE, 1, false), "boundary");
  says(error_of("gentle", vtkAreteFilter::EXTRAPOLATE, 30, false), "levels");
  says(error_of("four-point:omega=1", vtkAreteFilter::EXTRAPOLATE, 1, true), "limit");
}

TEST(refine_image, abort_in_mid_run_leaves_nothing_and_the_next_run_is_whole) {
  const Grid<double> heights = test::random_heights({300, 300});
  const vtkNew<vtkAreteRefineImage> refine;
  refine->SetInputData(test::image_of(heights));
  refine->SetLevels(3);
  std::vector<double> progress;
  bool abort = true;
  const vtkNew<vtkCallbackCommand> watcher;
  auto context = std::tie(progress, abort);
  watcher->SetClientData(&context);
  watcher->SetCallback([](vtkObject* caller, unsigned long, void* client, void*) {
    auto& [told, stop] = *static_cast<std::tuple<std::vector<double>&, bool&>*>(client);
    auto* filter = vtkAlgorithm::SafeDownCast(caller);
    told.push_back(filter->GetProgress());
    if (stop && filter->GetProgress() > 0.4) filter->AbortExecuteOn();
  });
  refine->AddObserver(vtkCommand::ProgressEvent, watcher);
  refine->Update();
  EXPECT_EQ(refine->GetOutput()->GetNumberOfPoints(), 0);
  ASSERT_GT(progress.size(), 2u);

  abort = false;
  progress.clear();
  refine->AbortExecuteOff();
  refine->Modified();
  refine->Update();
  RefineOptions options;
  options.levels = 3;
  EXPECT_TRUE(test::same_bits(test::grid_of(refine->GetOutput()),
                              arete::refine(heights, parse_scheme("gentle"), options)));
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(progress.back(), 1);
}

TEST(refine_image, settings_stay_in_range_and_print_themselves) {
  const vtkNew<vtkAreteRefineImage> refine;
  refine->SetLevels(1000);
  EXPECT_EQ(refine->GetLevels(), 30);
  refine->SetBoundaryX(-4);
  EXPECT_EQ(refine->GetBoundaryX(), vtkAreteFilter::EXTRAPOLATE);
  refine->SetBoundary(vtkAreteFilter::PERIODIC);
  EXPECT_EQ(refine->GetBoundaryY(), vtkAreteFilter::PERIODIC);
  refine->SetScheme("chaikin");
  std::ostringstream text;
  refine->Print(text);
  for (const char* part : {"Scheme: chaikin", "BoundaryX: periodic", "Levels: 30", "Limit: off"})
    EXPECT_NE(text.str().find(part), std::string::npos) << part;
}

}  // namespace
}  // namespace arete

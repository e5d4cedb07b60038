// SPDX-License-Identifier: MIT
// Every part of a refined image that a pipeline may ask for equals the same part of the whole.
#include <gtest/gtest.h>
#include <vtkAreteRefineImage.h>
#include <vtkCellData.h>
#include <vtkExecutive.h>
#include <vtkInformation.h>
#include <vtkIntArray.h>

#include <cmath>
#include <random>

#include "plugin/vtk/filters/exact_source.h"
#include "plugin/vtk/filters/images.h"
#include "support/fields.h"
#include "support/schemes.h"

namespace arete {
namespace {

// Points of the part whose values differ at all from those of the whole.
vtkIdType differing(vtkImageData* part, vtkImageData* whole) {
  vtkIdType count = 0;
  const int* e = part->GetExtent();
  const int* w = whole->GetExtent();
  for (int a = 0; a < whole->GetPointData()->GetNumberOfArrays(); ++a) {
    vtkDataArray* all = whole->GetPointData()->GetArray(a);
    vtkDataArray* some = part->GetPointData()->GetArray(all->GetName());
    if (!some || some->GetDataType() != all->GetDataType()) return part->GetNumberOfPoints();
    const auto size = static_cast<std::size_t>(all->GetDataTypeSize()) *
                      static_cast<std::size_t>(all->GetNumberOfComponents());
    const auto* p = static_cast<const char*>(some->GetVoidPointer(0));
    const auto* q = static_cast<const char*>(all->GetVoidPointer(0));
    for (int j = e[2]; j <= e[3]; ++j)
      for (int i = e[0]; i <= e[1]; ++i, p += size)
        if (std::memcmp(
                p, q + size * static_cast<std::size_t>((j - w[2]) * (w[1] - w[0] + 1) + i - w[0]),
                size) != 0)
          ++count;
  }
  return count;
}

// Heights and a vector, with some values missing and some points hidden.
vtkSmartPointer<vtkImageData> busy_image(unsigned seed, bool holes) {
  Grid<float> heights = test::random_heights<float>({19, 26}, seed);
  if (holes) heights(4, 7) = heights(11, 25) = NAN;
  auto image = test::image_of<vtkFloatArray>(heights, {-7, 3});
  const vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("wind");
  vectors->SetNumberOfComponents(2);
  vectors->SetNumberOfTuples(image->GetNumberOfPoints());
  std::mt19937 random(seed);
  for (vtkIdType i = 0; i < vectors->GetNumberOfValues(); ++i)
    vectors->SetValue(i, static_cast<double>(random()) / 1e7);
  image->GetPointData()->AddArray(vectors);
  if (holes) test::hide(image, {50, 51, 300});
  return image;
}

struct Pipeline {
  explicit Pipeline(vtkImageData* image) {
    source->SetImage(image);
    refine->SetInputConnection(source->GetOutputPort());
  }
  vtkSmartPointer<vtkImageData> output() {
    auto copy = vtkSmartPointer<vtkImageData>::New();
    copy->DeepCopy(refine->GetOutput());
    return copy;
  }
  vtkNew<test::ExactSource> source;
  vtkNew<vtkAreteRefineImage> refine;
};

std::array<int, 2> random_run(std::mt19937& random, int first, int last) {
  const auto count = static_cast<unsigned>(last - first + 1);
  const int a = first + static_cast<int>(random() % count);
  const int b = first + static_cast<int>(random() % count);
  return {std::min(a, b), std::max(a, b)};
}

TEST(refine_image_pieces, random_extents_equal_the_whole_for_all_schemes_boundaries_and_levels) {
  std::mt19937 random(1);
  int asked = 0;
  int less_than_all = 0;
  unsigned seed = 0;
  for (const Scheme& scheme : test::sample_schemes()) {
    for (int boundary = vtkAreteFilter::EXTRAPOLATE; boundary <= vtkAreteFilter::NONE; ++boundary) {
      ++seed;
      const auto image = busy_image(seed, seed % 2 == 0);
      Pipeline pipeline(image);
      pipeline.refine->SetScheme(scheme.text().c_str());
      pipeline.refine->SetBoundaryX(boundary);
      pipeline.refine->SetBoundaryY(
          boundary == vtkAreteFilter::NONE ? boundary : (boundary + 1) % vtkAreteFilter::NONE);
      for (int levels : {1, scheme.mask().arity() > 3 ? 1 : 2}) {
        pipeline.refine->SetLevels(levels);
        pipeline.refine->SetAlignment(static_cast<int>(seed % 2));
        const vtkNew<test::Errors> errors;
        errors->watch(pipeline.refine);
        errors->watch(pipeline.refine->GetExecutive());
        pipeline.refine->UpdateWholeExtent();
        if (boundary == vtkAreteFilter::NONE && errors->mention("leaves no sample")) continue;
        ASSERT_TRUE(errors->messages.empty()) << errors->messages.front();
        const auto whole = pipeline.output();
        for (int i = 0; i < 3; ++i) {
          const auto x = random_run(random, whole->GetExtent()[0], whole->GetExtent()[1]);
          const auto y = random_run(random, whole->GetExtent()[2], whole->GetExtent()[3]);
          int extent[6]{x[0], x[1], y[0], y[1], 0, 0};
          pipeline.source->Modified();  // what it holds already would serve as well
          pipeline.refine->UpdateExtent(extent);
          EXPECT_EQ(differing(pipeline.refine->GetOutput(), whole), 0)
              << scheme.text() << ", boundary " << boundary << ", levels " << levels;
          ++asked;
          const auto& input = pipeline.source->asked();
          if (input[1] - input[0] < 25 || input[3] - input[2] < 18) ++less_than_all;
        }
      }
    }
  }
  EXPECT_GT(asked, 700);
  EXPECT_GT(less_than_all, 100) << "a filter that always asks for everything proves nothing";
}

TEST(refine_image_pieces, pieces_of_the_executive_cover_the_whole_and_equal_it) {
  const auto image = busy_image(3, true);
  Pipeline pipeline(image);
  for (const char* scheme : {"gentle", "chaikin", "dubuc-deslauriers:points=8", "ternary-two-step",
                             "b-spline:degree=3"}) {
    pipeline.refine->SetScheme(scheme);
    pipeline.refine->SetLevels(2);
    pipeline.refine->UpdateWholeExtent();
    const auto whole = pipeline.output();
    for (int pieces : {2, 3, 5, 8, 64}) {
      std::vector<int> covered(static_cast<std::size_t>(whole->GetNumberOfPoints()));
      for (int piece = 0; piece < pieces; ++piece) {
        pipeline.source->Modified();
        pipeline.refine->UpdatePiece(piece, pieces, 0);
        vtkImageData* part = pipeline.refine->GetOutput();
        EXPECT_EQ(differing(part, whole), 0) << scheme << " " << piece << " of " << pieces;
        const int* e = part->GetExtent();
        const int* w = whole->GetExtent();
        for (int j = e[2]; j <= e[3]; ++j)
          for (int i = e[0]; i <= e[1]; ++i)
            ++covered[static_cast<std::size_t>((j - w[2]) * (w[1] - w[0] + 1) + i - w[0])];
      }
      EXPECT_EQ(std::count(covered.begin(), covered.end(), 0), 0) << scheme << " " << pieces;
    }
  }
}

TEST(refine_image_pieces, threads_change_nothing) {
  const auto image = test::image_of(test::random_heights({150, 90}));
  const vtkNew<vtkAreteRefineImage> refine;
  refine->SetInputData(image);
  refine->SetLevels(3);
  refine->SetNumberOfThreads(1);
  refine->Update();
  const Grid<double> one = test::grid_of(refine->GetOutput());
  for (int threads : {0, 2, 7}) {
    refine->SetNumberOfThreads(threads);
    refine->Update();
    EXPECT_TRUE(test::same_bits(test::grid_of(refine->GetOutput()), one)) << threads;
  }
}

TEST(refine_image_pieces, ghost_levels_are_given) {
  Pipeline pipeline(busy_image(4, false));
  pipeline.refine->SetLevels(2);
  pipeline.refine->UpdateWholeExtent();
  const auto whole = pipeline.output();
  pipeline.source->Modified();
  pipeline.refine->UpdatePiece(1, 4, 0);
  const std::array<int, 6> bare = [&] {
    std::array<int, 6> e{};
    pipeline.refine->GetOutput()->GetExtent(e.data());
    return e;
  }();
  pipeline.source->Modified();
  pipeline.refine->UpdatePiece(1, 4, 2);
  vtkImageData* part = pipeline.refine->GetOutput();
  EXPECT_GT(part->GetNumberOfPoints(), (bare[1] - bare[0] + 1) * (bare[3] - bare[2] + 1));
  part->GetPointData()->RemoveArray(vtkDataSetAttributes::GhostArrayName());
  EXPECT_EQ(differing(part, whole), 0);
}

// A filter that asks for less than it needs.
class BrokenHalo : public vtkAreteRefineImage {
 public:
  static BrokenHalo* New();
  vtkTypeMacro(BrokenHalo, vtkAreteRefineImage);

 protected:
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                          vtkInformationVector* outputs) override {
    const int result = Superclass::RequestUpdateExtent(request, inputs, outputs);
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    int extent[6];
    in->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent);
    extent[0] += 1;
    in->Set(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), extent, 6);
    return result;
  }
};
vtkStandardNewMacro(BrokenHalo);

TEST(refine_image_pieces, a_halo_that_is_too_small_is_an_error_and_no_numbers) {
  const vtkNew<test::ExactSource> source;
  source->SetImage(busy_image(5, false));
  const vtkNew<BrokenHalo> refine;
  refine->SetInputConnection(source->GetOutputPort());
  const vtkNew<test::Errors> errors;
  errors->watch(refine);
  errors->watch(refine->GetExecutive());
  refine->UpdatePiece(3, 4, 0);
  EXPECT_TRUE(errors->mention("needs"));
  EXPECT_EQ(refine->GetOutput()->GetNumberOfPoints(), 0);
}

}  // namespace
}  // namespace arete

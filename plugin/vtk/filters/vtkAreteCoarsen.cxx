// SPDX-License-Identifier: MIT
#include "vtkAreteCoarsen.h"

#include "arete/reverse/details_file.h"
#include "arete/reverse/threshold.h"
#include "internal/guarded.h"
#include "internal/image_notes.h"
#include "internal/image_place.h"
#include "internal/settings.h"
#include "internal/structured_refine.h"
#include "internal/structured_request.h"
#include "internal/whole_image.h"
#include "vtkDataObject.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkImageData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkUnsignedCharArray.h"

using namespace arete::vtk_filters;

vtkStandardNewMacro(vtkAreteCoarsen);

vtkAreteCoarsen::vtkAreteCoarsen() = default;
vtkAreteCoarsen::~vtkAreteCoarsen() = default;

vtkImageData* vtkAreteCoarsen::GetOutput() { return this->GetOutput(0); }

vtkImageData* vtkAreteCoarsen::GetOutput(int port) {
  return vtkImageData::SafeDownCast(this->GetOutputDataObject(port));
}

int vtkAreteCoarsen::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkImageData");
  return 1;
}

int vtkAreteCoarsen::FillOutputPortInformation(int, vtkInformation* info) {
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkImageData");
  return 1;
}

namespace {

struct Reverse {
  arete::Scheme scheme;
  arete::GridReverseOptions options;
  arete::GridPyramid pyramid;

  [[nodiscard]] arete::Extent coarse() const { return pyramid.extent(options.levels); }
};

Reverse reverse_of(vtkAreteCoarsen* filter, const VtkExtent& whole) {
  const Settings settings = settings_of(filter);
  if (!(settings.x == settings.y))
    throw arete::InvalidField("both axes are taken apart by one scheme; leave SchemeY empty");
  if (whole[4] != whole[5])
    throw arete::InvalidField("only flat images can be taken apart, this one has " +
                              std::to_string(count_along(whole, 2)) +
                              " slices along k; extract one (vtkExtractVOI)");
  const arete::GridReverseOptions options{filter->GetLevels(),
                                          filter->GetMode() == vtkAreteCoarsen::LOCAL
                                              ? arete::ReverseMode::local
                                              : arete::ReverseMode::least_squares,
                                          settings.boundaries, settings.threads};
  return {settings.x, options,
          arete::GridPyramid(settings.x.mask(), {count_along(whole, 1), count_along(whole, 0)},
                             options)};
}

VtkExtent coarse_extent(const Reverse& reverse, const VtkExtent& whole) {
  const arete::Extent size = reverse.coarse();
  return {0,       static_cast<int>(size.cols) - 1, 0, static_cast<int>(size.rows) - 1, whole[4],
          whole[5]};
}

StepsAlong steps_along(const arete::AxisPlacement& place, int first) {
  return {first + place.first, place.spacing};
}

// Takes one plane apart; its details go to `file`.
arete::Grid<double> coarsened_plane(arete::Grid<double> samples, const Reverse& reverse,
                                    double threshold, arete::ValidSamples& valid,
                                    arete::DetailsFile& file) {
  arete::BandDetails band;
  band.valid = arete::fill_missing(samples.view());
  valid = arete::coarsened(band.valid, reverse.pyramid, reverse.options.levels);
  auto parts = arete::decompose_grid<double>(samples.view(), reverse.scheme, reverse.options);
  if (file.lossy) arete::drop_details(parts, threshold);
  for (std::size_t i = 0; i < valid.size(); ++i)
    if (valid[i] == 0) band.hidden.push_back(parts.coarse.samples()[i]);
  band.coarse_checksum = arete::checksum(parts.coarse.samples());
  band.details = std::move(parts.details);
  file.bands.push_back(std::move(band));
  return std::move(parts.coarse);
}

void keep_details(const arete::DetailsFile& file, vtkImageData* output) {
  const arete::Bytes bytes = arete::encode_details(file);
  const vtkNew<vtkUnsignedCharArray> array;
  array->SetName("AreteDetails");
  array->SetNumberOfTuples(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), array->GetPointer(0));
  output->GetFieldData()->AddArray(array);
}

}  // namespace

int vtkAreteCoarsen::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    const VtkExtent whole = whole_extent(in);
    if (is_empty(whole)) {
      announce(out, whole);
      return 1;
    }
    const Reverse reverse = reverse_of(this, whole);
    const int levels = reverse.options.levels;
    announce_image(in, out, coarse_extent(reverse, whole),
                   steps_along(reverse.pyramid.col_placement(levels), whole[0]),
                   steps_along(reverse.pyramid.row_placement(levels), whole[2]));
    return 1;
  });
}

int vtkAreteCoarsen::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                         vtkInformationVector*) {
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  request_extent(in, whole_extent(in));
  return 1;
}

int vtkAreteCoarsen::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  return guarded(this, vtkDataObject::GetData(outputs), [&] {
    vtkInformation* in = inputs[0]->GetInformationObject(0);
    vtkInformation* out = outputs->GetInformationObject(0);
    vtkImageData* input = vtkImageData::GetData(in);
    vtkImageData* output = vtkImageData::GetData(out);
    const VtkExtent wanted = update_extent(out);
    if (is_empty(wanted) || input->GetNumberOfPoints() == 0) return 1;

    const VtkExtent whole = whole_extent(in);
    VtkExtent held;
    input->GetExtent(held.data());
    if (!contains(held, whole))
      throw arete::InvalidField("taking an image apart needs all of it at once; gather its pieces");
    const Reverse reverse = reverse_of(this, whole);
    const std::vector<vtkDataArray*> arrays = refinable_arrays(input->GetPointData());
    const ImageNotes notes = ImageNotes::of(input, arrays);
    arete::DetailsFile file{reverse.scheme.text(),
                            reverse.options.mode,
                            reverse.options.boundaries,
                            reverse.options.levels,
                            reverse.pyramid.extent(0),
                            this->Threshold > 0,
                            notes.text(),
                            {}};

    lay_out(out, coarse_extent(reverse, whole), output);
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    Work work(this, notes.bands());
    arete::ValidSamples valid;
    for (vtkDataArray* array : arrays) {
      const auto coarse = refined_like(array, output->GetNumberOfPoints(), VTK_DOUBLE);
      for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
        const auto plane =
            coarsened_plane(whole_plane(input, array, c), reverse, this->Threshold, valid, file);
        put_plane(plane, valid, coarse, c);
        if (!work.done(1)) {
          output->Initialize();
          return 1;
        }
      }
      add_like(input->GetPointData(), array, output->GetPointData(), coarse);
    }
    if (input->GetPointGhostArray() && !arrays.empty()) hide_points(valid, output);
    if (this->KeepDetails && !arrays.empty()) keep_details(file, output);
    output->Crop(wanted.data());
    return 1;
  });
}

void vtkAreteCoarsen::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Levels: " << this->Levels << "\n";
  os << indent << "Mode: " << (this->Mode == LOCAL ? "local" : "least-squares") << "\n";
  os << indent << "KeepDetails: " << (this->KeepDetails ? "on" : "off") << "\n";
  os << indent << "Threshold: " << this->Threshold << "\n";
}

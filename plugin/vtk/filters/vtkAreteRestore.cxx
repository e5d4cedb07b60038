// SPDX-License-Identifier: MIT
#include "vtkAreteRestore.h"

#include <cmath>

#include "arete/reverse/details_file.h"
#include "arete/scheme/catalogue.h"
#include "internal/guarded.h"
#include "internal/image_notes.h"
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

vtkStandardNewMacro(vtkAreteRestore);

vtkAreteRestore::vtkAreteRestore() = default;
vtkAreteRestore::~vtkAreteRestore() = default;

namespace {

constexpr const char* details_name = "AreteDetails";

struct Details {
  arete::DetailsFile file;
  ImageNotes notes;
};

Details details_of(vtkImageData* image) {
  auto* bytes =
      image ? vtkUnsignedCharArray::SafeDownCast(image->GetFieldData()->GetArray(details_name))
            : nullptr;
  if (!bytes)
    throw arete::InvalidField(
        "the image has no field data \"AreteDetails\"; give the result of vtkAreteCoarsen with "
        "KeepDetails on");
  Details details{arete::decode_details(
                      {bytes->GetPointer(0), static_cast<std::size_t>(bytes->GetNumberOfValues())}),
                  {}};
  details.notes = ImageNotes::parse(details.file.notes);
  const auto& e = details.notes.extent;
  if (details.notes.bands() != static_cast<int>(details.file.bands.size()) ||
      details.file.fine != arete::Extent{count_along(e, 1), count_along(e, 0)})
    throw arete::InvalidField("the field data \"AreteDetails\" contradict themselves");
  return details;
}

// The coarse plane as the details know it, hidden values put back.
arete::Grid<double> coarse_plane(arete::Grid<double> plane, const arete::BandDetails& band,
                                 const arete::ValidSamples& valid, const std::string& name,
                                 bool edited) {
  std::size_t hidden = 0;
  for (std::size_t i = 0; i < plane.samples().size(); ++i) {
    if (!valid.empty() && valid[i] == 0)
      plane.samples()[i] = band.hidden.at(hidden++);
    else if (!std::isfinite(plane.samples()[i]))
      throw arete::InvalidField("array " + name + ": point " + std::to_string(i) +
                                " is missing where the details expect a value");
  }
  if (!edited && arete::checksum(plane.samples()) != band.coarse_checksum)
    throw arete::InvalidField("array " + name +
                              " is not the one that the details were made with; switch Edited on "
                              "if it was changed on purpose");
  return plane;
}

}  // namespace

int vtkAreteRestore::RequestInformation(vtkInformation*, vtkInformationVector** inputs,
                                        vtkInformationVector* outputs) {
  return guarded(this, [&] {
    vtkInformation* out = outputs->GetInformationObject(0);
    // Where the result lies is written in the data, so these must be there first.
    int port = 0;
    vtkAlgorithm* upstream = this->GetInputAlgorithm(0, 0, port);
    upstream->Update(port);
    vtkImageData* input = vtkImageData::GetData(upstream->GetOutputInformation(port));
    (void)inputs;
    if (!input || input->GetNumberOfPoints() == 0) {
      announce(out, {0, -1, 0, -1, 0, -1});
      return 1;
    }
    const ImageNotes notes = details_of(input).notes;
    announce(out, notes.extent);
    out->Set(vtkDataObject::ORIGIN(), notes.origin.data(), 3);
    out->Set(vtkDataObject::SPACING(), notes.spacing.data(), 3);
    out->Set(vtkDataObject::DIRECTION(), notes.direction.data(), 9);
    return 1;
  });
}

int vtkAreteRestore::RequestUpdateExtent(vtkInformation*, vtkInformationVector** inputs,
                                         vtkInformationVector*) {
  vtkInformation* in = inputs[0]->GetInformationObject(0);
  request_extent(in, whole_extent(in));
  return 1;
}

int vtkAreteRestore::RequestData(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  return guarded(this, vtkDataObject::GetData(outputs), [&] {
    vtkInformation* out = outputs->GetInformationObject(0);
    vtkImageData* input = vtkImageData::GetData(inputs[0]->GetInformationObject(0));
    vtkImageData* output = vtkImageData::GetData(out);
    const VtkExtent wanted = update_extent(out);
    if (is_empty(wanted) || input->GetNumberOfPoints() == 0) return 1;

    Details details = details_of(input);
    const arete::Scheme scheme = arete::parse_scheme(details.file.scheme);
    const arete::GridReverseOptions options = details.file.options(0);
    const arete::GridPyramid pyramid(scheme.mask(), details.file.fine, options);
    const int* size = input->GetDimensions();
    if (pyramid.extent(options.levels) != arete::Extent{size[1], size[0]})
      throw arete::InvalidField("the coarse image has another size than its details expect");

    details.notes.place(output);
    output->GetFieldData()->ShallowCopy(input->GetFieldData());
    output->GetFieldData()->RemoveArray(details_name);
    Work work(this, details.notes.bands());
    std::size_t number = 0;
    arete::ValidSamples fine_valid;
    for (const ImageNotes::Array& known : details.notes.arrays) {
      vtkDataArray* array = input->GetPointData()->GetArray(known.name.c_str());
      if (!array || array->GetNumberOfComponents() != known.components)
        throw arete::InvalidField("the coarse image has lost its array " + known.name);
      const auto fine = refined_like(array, output->GetNumberOfPoints(), VTK_DOUBLE);
      for (int c = 0; c < known.components; ++c) {
        arete::BandDetails& band = details.file.bands[number++];
        const auto valid = arete::coarsened(band.valid, pyramid, options.levels);
        const arete::GridDecomposition<double> parts{
            coarse_plane(whole_plane(input, array, c), band, valid, known.name, this->Edited != 0),
            std::move(band.details)};
        fine_valid = std::move(band.valid);
        put_plane(
            arete::reconstruct_grid(parts, details.file.fine, scheme, options, options.levels),
            fine_valid, fine, c);
        if (!work.done(1)) {
          output->Initialize();
          return 1;
        }
      }
      add_like(input->GetPointData(), array, output->GetPointData(), fine);
    }
    if (details.notes.hides) hide_points(fine_valid, output);
    output->Crop(wanted.data());
    return 1;
  });
}

void vtkAreteRestore::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Edited: " << (this->Edited ? "on" : "off") << "\n";
}

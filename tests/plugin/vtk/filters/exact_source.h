// SPDX-License-Identifier: MIT
#pragma once

#include <vtkDataArray.h>
#include <vtkImageAlgorithm.h>
#include <vtkImageData.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkSmartPointer.h>
#include <vtkStreamingDemandDrivenPipeline.h>

#include <array>

namespace arete::test {

/// A source that gives exactly the points it is asked for, as a reader of a large file would; a
/// filter that reads beyond what it asked for reads beyond the arrays. It remembers the request.
class ExactSource : public vtkImageAlgorithm {
 public:
  static ExactSource* New();
  vtkTypeMacro(ExactSource, vtkImageAlgorithm);

  void SetImage(vtkImageData* image) { image_ = image; }
  [[nodiscard]] const std::array<int, 6>& asked() const { return asked_; }

 protected:
  ExactSource() { this->SetNumberOfInputPorts(0); }

  int RequestInformation(vtkInformation*, vtkInformationVector**,
                         vtkInformationVector* outputs) override {
    vtkInformation* out = outputs->GetInformationObject(0);
    out->Set(vtkStreamingDemandDrivenPipeline::WHOLE_EXTENT(), image_->GetExtent(), 6);
    out->Set(vtkDataObject::SPACING(), image_->GetSpacing(), 3);
    out->Set(vtkDataObject::ORIGIN(), image_->GetOrigin(), 3);
    out->Set(vtkAlgorithm::CAN_PRODUCE_SUB_EXTENT(), 1);
    return 1;
  }

  int RequestData(vtkInformation*, vtkInformationVector**, vtkInformationVector* outputs) override {
    vtkInformation* out = outputs->GetInformationObject(0);
    out->Get(vtkStreamingDemandDrivenPipeline::UPDATE_EXTENT(), asked_.data());
    vtkImageData* output = vtkImageData::GetData(out);
    output->ShallowCopy(image_);
    output->Crop(asked_.data());
    return 1;
  }

 private:
  vtkSmartPointer<vtkImageData> image_;
  std::array<int, 6> asked_{};
};
inline vtkStandardNewMacro(ExactSource);

}  // namespace arete::test

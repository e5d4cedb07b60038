// SPDX-License-Identifier: MIT
#include <vtkImageData.h>
#include <vtkImageInterpolator.h>
#include <vtkImageResize.h>
#include <vtkMultiThreader.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <algorithm>

#include "peer.h"

namespace arete::bench {
namespace {

Run image_resize(const Job& job) {
  // Like the others here: one thread.
  vtkMultiThreader::SetGlobalMaximumNumberOfThreads(1);
  const vtkSmartPointer<vtkImageData> image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(static_cast<int>(job.heights.cols()), static_cast<int>(job.heights.rows()),
                       1);
  image->AllocateScalars(VTK_FLOAT, 1);
  std::copy(job.heights.samples().begin(), job.heights.samples().end(),
            static_cast<float*>(image->GetScalarPointer()));
  const Extent fine = job.fine();
  return {[image, fine] {
            vtkNew<vtkImageResize> resize;
            vtkNew<vtkImageInterpolator> cubic;
            cubic->SetInterpolationModeToCubic();
            resize->SetInputData(image);
            resize->SetInterpolator(cubic);
            resize->SetOutputDimensions(static_cast<int>(fine.cols), static_cast<int>(fine.rows),
                                        1);
            resize->BorderOff();
            resize->Update();
          },
          {}};
}

}  // namespace

std::vector<Peer> vtk_peers() {
  return {{"VTK, vtkImageResize cubic", false, true, 10, 5, image_resize}};
}

}  // namespace arete::bench

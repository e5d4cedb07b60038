// SPDX-License-Identifier: MIT
#pragma once

#include <vtkImageData.h>
#include <vtkNew.h>

#include "arete/vtk/image.h"

namespace arete::vtk {

/// A picture as VTK has it: the lowest row first.
[[nodiscard]] vtkNew<vtkImageData> to_vtk(const Image& image);

}  // namespace arete::vtk

// SPDX-License-Identifier: MIT
// Stands in for egl_context.cpp where there is no EGL to build with.
#include "arete/vtk/internal/egl_context.h"

namespace arete::vtk {

EglContext::EglContext() = default;
EglContext::~EglContext() = default;

}  // namespace arete::vtk

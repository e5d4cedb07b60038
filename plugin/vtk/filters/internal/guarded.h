// SPDX-License-Identifier: MIT
#pragma once

#include <exception>
#include <new>

#include "vtkDataObject.h"
#include "vtkObject.h"

namespace arete::vtk_filters {

/// Runs one request of a filter. Whatever is thrown becomes an error of the filter, as VTK wants
/// it, and the request fails.
template <class Filter, class Request>
int guarded(Filter* self, Request&& request) {
  try {
    return request();
  } catch (const std::bad_alloc&) {
    vtkErrorWithObjectMacro(self, << "not enough memory; use fewer levels or more pieces");
  } catch (const std::exception& error) {
    vtkErrorWithObjectMacro(self, << error.what());
  }
  return 0;
}

/// The same for the request that fills `output`: a failed one leaves nothing half made.
template <class Filter, class Request>
int guarded(Filter* self, vtkDataObject* output, Request&& request) {
  output->Initialize();
  const int result = guarded(self, request);
  if (result == 0) output->Initialize();
  return result;
}

}  // namespace arete::vtk_filters

// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "arete/field/boundary.h"
#include "arete/scheme/scheme.h"
#include "arete/scheme/stencil.h"

class vtkAreteFilter;

namespace arete::vtk_filters {

/// What a filter is set to, in the terms of the library.
struct Settings {
  Scheme x;
  Scheme y;
  Boundaries boundaries;
  int threads = 0;
};

/// \throws InvalidScheme for a scheme that cannot be read.
[[nodiscard]] Settings settings_of(vtkAreteFilter* filter);

/// The stencil of the limit (order 0) or of its derivative (order 1) of a scheme, if it is
/// certified to have one. Remembered, because finding it can take a second and a pipeline asks
/// often. Thread-safe.
[[nodiscard]] std::optional<Stencil> limit_of(const Scheme& scheme, int order);
/// \throws InvalidScheme if there is none.
[[nodiscard]] Stencil required_limit_of(const Scheme& scheme);

}  // namespace arete::vtk_filters

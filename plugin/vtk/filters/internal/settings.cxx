// SPDX-License-Identifier: MIT
#include "internal/settings.h"

#include <map>
#include <mutex>

#include "arete/analysis/limit_stencil.h"
#include "arete/scheme/catalogue.h"
#include "vtkAreteFilter.h"

namespace arete::vtk_filters {

Settings settings_of(vtkAreteFilter* filter) {
  const Scheme x = parse_scheme(filter->GetSchemeInUse());
  const char* other = filter->GetSchemeY();
  return {x, other && *other ? parse_scheme(other) : x,
          Boundaries{static_cast<Boundary>(filter->GetBoundaryX()),
                     static_cast<Boundary>(filter->GetBoundaryY())},
          filter->GetNumberOfThreads()};
}

std::optional<Stencil> limit_of(const Scheme& scheme, int order) {
  static std::mutex guard;
  static std::map<std::pair<std::string, int>, std::optional<Stencil>> known;
  const std::lock_guard lock(guard);
  const std::pair<std::string, int> key(scheme.text(), order);
  const auto found = known.find(key);
  if (found != known.end()) return found->second;
  return known[key] = derivative_stencil(scheme.mask(), order);
}

Stencil required_limit_of(const Scheme& scheme) {
  auto stencil = limit_of(scheme, 0);
  if (!stencil)
    throw InvalidScheme(scheme.text() +
                        " is not certified to have a limit; switch Limit off or choose another "
                        "scheme");
  return *stencil;
}

}  // namespace arete::vtk_filters

// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Utils/BaseProperty.hh>
#include <span>

namespace arete::openmesh::detail {

/// Entry i of the property becomes what entry sources[i] was, whatever type it holds; -1 gives a
/// default value.
inline void gather(::OpenMesh::BaseProperty& property, std::span<const int> sources) {
  // Values of unknown type can only be copied within their own property, so the old ones, followed
  // by a default one, are first put out of the way.
  const std::size_t old = property.n_elements();
  const std::size_t count = sources.size();
  const std::size_t stash = count + old + 1;
  property.resize(stash + old + 1);
  for (std::size_t i = 0; i <= old; ++i) property.copy(i, stash + i);
  for (std::size_t i = 0; i < count; ++i)
    property.copy(stash + (sources[i] < 0 ? old : static_cast<std::size_t>(sources[i])), i);
  property.resize(count);
}

}  // namespace arete::openmesh::detail

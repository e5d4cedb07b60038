// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Utils/Property.hh>
#include <array>
#include <cstdint>

#include "arete/openmesh/internal/components.h"

namespace arete::openmesh::detail {

template <class... Scalars>
struct NumbersAndVectors {
  /// Calls f.template operator()<T>(PropertyT<T>&) when the property holds numbers or vectors of
  /// them; false if it holds something else.
  template <class F>
  static bool visit(::OpenMesh::BaseProperty& property, F&& f) {
    return (visit_scalar<Scalars>(property, f) || ...);
  }
  template <class T, class F>
  static bool visit_one(::OpenMesh::BaseProperty& property, F&& f) {
    auto* const typed = dynamic_cast<::OpenMesh::PropertyT<T>*>(&property);
    if (typed) f(*typed);
    return typed != nullptr;
  }

 private:
  template <class S, class F>
  static bool visit_scalar(::OpenMesh::BaseProperty& property, F&& f) {
    using ::OpenMesh::VectorT;
    return visit_one<S>(property, f) || visit_one<VectorT<S, 1>>(property, f) ||
           visit_one<VectorT<S, 2>>(property, f) || visit_one<VectorT<S, 3>>(property, f) ||
           visit_one<VectorT<S, 4>>(property, f) || visit_one<VectorT<S, 5>>(property, f) ||
           visit_one<VectorT<S, 6>>(property, f) || visit_one<std::array<S, 2>>(property, f) ||
           visit_one<std::array<S, 3>>(property, f) || visit_one<std::array<S, 4>>(property, f);
  }
};

using KnownTypes =
    NumbersAndVectors<float, double, int, unsigned, short, unsigned short, char, signed char,
                      unsigned char, long, unsigned long, long long, unsigned long long>;

}  // namespace arete::openmesh::detail

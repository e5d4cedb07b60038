// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Geometry/VectorT.hh>
#include <OpenMesh/Core/Utils/vector_traits.hh>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

namespace arete::openmesh::detail {

/// A property value as numbers: how many, and each one to read and write. Numbers, std::array and
/// whatever OpenMesh::vector_traits knows (its own vectors, Eigen's).
template <class T>
struct Components {
  using Scalar = typename ::OpenMesh::vector_traits<T>::value_type;
  static constexpr std::size_t count = ::OpenMesh::vector_traits<T>::size_;
  static Scalar get(const T& value, std::size_t k) { return value[static_cast<int>(k)]; }
  static void set(T& value, std::size_t k, Scalar x) { value[static_cast<int>(k)] = x; }
};

template <class T>
requires std::is_arithmetic_v<T>
struct Components<T> {
  using Scalar = T;
  static constexpr std::size_t count = 1;
  static Scalar get(const T& value, std::size_t) { return value; }
  static void set(T& value, std::size_t, Scalar x) { value = x; }
};

template <class S, std::size_t N>
requires std::is_arithmetic_v<S>
struct Components<std::array<S, N>> {
  using Scalar = S;
  static constexpr std::size_t count = N;
  static Scalar get(const std::array<S, N>& value, std::size_t k) { return value[k]; }
  static void set(std::array<S, N>& value, std::size_t k, Scalar x) { value[k] = x; }
};

/// Types that Components can be asked about without a compile error.
template <class T>
concept HasComponents = std::is_arithmetic_v<T> || requires {
  typename T::value_type;
  T::size_;
} || requires {
  T::RowsAtCompileTime;
};

/// All components zero. OpenMesh's own vectors leave T() uninitialised.
template <class T>
T zero() {
  T value{};
  for (std::size_t k = 0; k < Components<T>::count; ++k)
    Components<T>::set(value, k, typename Components<T>::Scalar(0));
  return value;
}

/// The number nearest to x that the type can hold; NaN becomes 0 where there is no NaN.
template <class Scalar, class Real>
Scalar rounded(Real x) {
  if constexpr (std::is_floating_point_v<Scalar>) {
    return static_cast<Scalar>(x);
  } else {
    using Limits = std::numeric_limits<Scalar>;
    if (std::isnan(x)) return Scalar(0);
    const Real whole = std::round(x);
    // The largest 64-bit integers are no floating-point numbers; their rounded values are too
    // large.
    if (whole <= static_cast<Real>(Limits::min())) return Limits::min();
    if (whole >= static_cast<Real>(Limits::max())) return Limits::max();
    return static_cast<Scalar>(whole);
  }
}

}  // namespace arete::openmesh::detail

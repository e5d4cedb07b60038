// SPDX-License-Identifier: MIT
#pragma once

#include "arete/refine/kernel/kernel.h"

namespace arete {

template <class T>
struct KernelTables {
  static const Kernels<T> baseline;  ///< what every machine of the architecture runs
  static const Kernels<T> avx2;
  static const Kernels<T> avx512;
};

// The table of the instruction set that the file including this is compiled for.
#define ARETE_KERNEL_TABLE(set, name)                                                 \
  template <>                                                                         \
  const Kernels<float> KernelTables<float>::set{combine<float>, weave_for<float>,     \
                                                all_finite<float>, fence, name};      \
  template <>                                                                         \
  const Kernels<double> KernelTables<double>::set{combine<double>, weave_for<double>, \
                                                  all_finite<double>, fence, name};

}  // namespace arete

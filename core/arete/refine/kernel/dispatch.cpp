// SPDX-License-Identifier: MIT
#include <cstdlib>

#include "arete/refine/kernel/table.h"

namespace arete {

// Defined in the files of the instruction sets.
template <>
const Kernels<float> KernelTables<float>::baseline;
template <>
const Kernels<double> KernelTables<double>::baseline;
#if defined(__x86_64__)
template <>
const Kernels<float> KernelTables<float>::avx2;
template <>
const Kernels<double> KernelTables<double>::avx2;
template <>
const Kernels<float> KernelTables<float>::avx512;
template <>
const Kernels<double> KernelTables<double>::avx512;
#endif

namespace {

template <class T>
std::vector<const Kernels<T>*> runnable() {
  std::vector<const Kernels<T>*> kernels{&KernelTables<T>::baseline};
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (__builtin_cpu_supports("avx2")) kernels.push_back(&KernelTables<T>::avx2);
  if (__builtin_cpu_supports("avx512f")) kernels.push_back(&KernelTables<T>::avx512);
#endif
  return kernels;
}

template <class T>
const Kernels<T>& chosen() {
  const auto& available = available_kernels<T>();
  if (const char* wanted = std::getenv("ARETE_KERNEL"))
    for (const Kernels<T>* kernels : available)
      if (kernels->name == wanted) return *kernels;
  return *available.back();
}

}  // namespace

template <class T>
const std::vector<const Kernels<T>*>& available_kernels() {
  static const std::vector<const Kernels<T>*> kernels = runnable<T>();
  return kernels;
}

template <class T>
const Kernels<T>& kernels() {
  static const Kernels<T>& best = chosen<T>();
  return best;
}

template const std::vector<const Kernels<float>*>& available_kernels();
template const std::vector<const Kernels<double>*>& available_kernels();
template const Kernels<float>& kernels();
template const Kernels<double>& kernels();

}  // namespace arete

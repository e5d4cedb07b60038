// SPDX-License-Identifier: MIT
#define ARETE_KERNEL_BYTES 64
#include "arete/refine/kernel/kernel_impl.h"
#include "arete/refine/kernel/table.h"

namespace arete {

ARETE_KERNEL_TABLE(avx512, "avx512")

}  // namespace arete

// SPDX-License-Identifier: MIT
#define ARETE_KERNEL_BYTES 16
#include "arete/refine/kernel/kernel_impl.h"
#include "arete/refine/kernel/table.h"

namespace arete {

ARETE_KERNEL_TABLE(baseline, "baseline")

}  // namespace arete

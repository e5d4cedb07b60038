// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>

#include "cli/scheme_json.h"

namespace arete::cli {

/// null where there is no number: JSON has neither NaN nor infinity.
[[nodiscard]] inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

}  // namespace arete::cli

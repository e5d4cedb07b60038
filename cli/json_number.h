// SPDX-License-Identifier: MIT
#pragma once

#include <cmath>
#include <optional>

#include "arete/metrics/spectrum.h"
#include "cli/scheme_json.h"

namespace arete::cli {

/// null where there is no number: JSON has neither NaN nor infinity.
[[nodiscard]] inline Json number_or_null(double value) {
  return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// null where no slope could be measured.
[[nodiscard]] inline Json slope_or_null(const std::optional<SpectralSlope>& spectrum) {
  return spectrum ? number_or_null(spectrum->slope) : Json(nullptr);
}

}  // namespace arete::cli

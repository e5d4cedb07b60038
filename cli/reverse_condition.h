// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/scheme/mask.h"
#include "cli/scheme_json.h"

namespace arete::cli {

/// How well a scheme can be undone: {"least_squares": {"noise_gain", "condition"}, "local": ...},
/// null where there is no reverse in that mode (reverse/condition.h).
[[nodiscard]] Json reverse_condition_json(const Mask& mask);

/// The same as a line for people.
[[nodiscard]] std::string reverse_condition_text(const Mask& mask);

}  // namespace arete::cli

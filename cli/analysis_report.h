// SPDX-License-Identifier: MIT
#pragma once

#include "arete/analysis/theorem.h"
#include "cli/scheme_json.h"

namespace arete::cli {

/// What `arete analyze --json` prints: the keys of `describe`, and what is proved.
[[nodiscard]] Json analysis_json(const Scheme& scheme, const Smoothness& truth);

/// The same for people, on standard output.
void print_analysis(const Scheme& scheme, const Smoothness& truth);

}  // namespace arete::cli

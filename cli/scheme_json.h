// SPDX-License-Identifier: MIT
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "arete/scheme/catalogue.h"
#include "arete/scheme/stencil.h"

namespace arete::cli {

/// Keys keep the order in which they are documented.
using Json = nlohmann::ordered_json;

/// The object of `arete describe --json` (docs/cli.md lists its keys).
[[nodiscard]] Json describe(const Scheme& scheme);

/// A scheme back from such an object (only its key "scheme" is read, the text form).
/// \throws InvalidScheme
[[nodiscard]] Scheme scheme_from_json(const std::string& text, const std::string& where);

/// What stands behind --scheme: the text form, or @FILE.json written by `arete describe --json`.
[[nodiscard]] Scheme read_scheme(const std::string& argument);

/// `{"-1": "1/6", "0": "2/3", "1": "1/6"}`.
[[nodiscard]] Json stencil_json(const Stencil& stencil);

}  // namespace arete::cli

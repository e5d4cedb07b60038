// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "arete/vtk/palette.h"

namespace arete::cli {

/// A palette from JSON (docs/render.md describes it). Every key is checked: one that is unknown, of
/// the wrong kind or out of range is named with its place in the file.
/// \param where names the file in messages. \throws Failure
[[nodiscard]] vtk::Palette palette_from_json(const std::string& text, const std::string& where);

/// What stands behind --palette: a name, or a file that ends in .json.
[[nodiscard]] vtk::Palette read_palette(const std::string& argument);

}  // namespace arete::cli

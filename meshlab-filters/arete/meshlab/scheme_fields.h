// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/meshlab/fields.h"
#include "arete/scheme/scheme.h"

namespace arete::meshlab {

/// The families a dialog offers, in the order that scripts know by number: new ones go to the end.
/// A test holds this list against the catalogue. Families that need a list of numbers are reached
/// through the field SchemeText.
[[nodiscard]] const std::vector<std::string>& offered_families();

/// The fields by which every filter asks for a scheme: Scheme, Lambda, Mu, Nu, Omega (which
/// `four-parameter` reads) and SchemeText (any scheme in the library's text form; goes first).
[[nodiscard]] std::vector<Field> scheme_fields();

/// The scheme that was asked for. \throws InvalidScheme as parse_scheme.
[[nodiscard]] Scheme chosen_scheme(const Values& values);

}  // namespace arete::meshlab

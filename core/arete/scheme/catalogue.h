// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "arete/scheme/scheme.h"

namespace arete {

/// A named family of schemes: its knobs and how they make a mask.
struct Family {
  std::string name;       ///< `four-parameter`; part of the text form, never changed
  std::string summary;    ///< one line
  std::string reference;  ///< whose scheme it is
  std::vector<Parameter> parameters;
  std::function<Mask(const ParameterValues&)> build;
};

/// THE table of families: the command line, the dialogs, the documentation and the law tests
/// iterate it. A new family is one header in family/, one row here, one page of documentation.
[[nodiscard]] const std::vector<Family>& catalogue();

/// The row of that name. \throws InvalidScheme with the nearest names if there is none.
[[nodiscard]] const Family& find_family(std::string_view name);

/// A member of the family; parameters left out take their defaults.
/// \throws InvalidScheme for an unknown name or parameter, a value given twice, missing, out of
/// range or not an integer where one is needed, or a mask whose phases do not sum to 1.
[[nodiscard]] Scheme make_scheme(std::string_view family, const ParameterValues& values = {});

/// Reads the text form `name` or `name:key=value,key=value`; a value is `7/32`, `0.21875`, or for
/// lists `-1/16;0;9/16`. \throws InvalidScheme as make_scheme, and for text of any other shape.
[[nodiscard]] Scheme parse_scheme(std::string_view text);

}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/field/boundary.h"

#include <array>
#include <string>

namespace arete {
namespace {

constexpr std::array<std::pair<std::string_view, Boundary>, 5> names{
    {{"extrapolate", Boundary::extrapolate},
     {"clamp", Boundary::clamp},
     {"reflect", Boundary::reflect},
     {"periodic", Boundary::periodic},
     {"none", Boundary::none}}};

Index modulo(Index a, Index n) { return ((a % n) + n) % n; }

}  // namespace

Boundary parse_boundary(std::string_view text) {
  for (const auto& [name, boundary] : names)
    if (name == text) return boundary;
  throw InvalidField("there is no boundary '" + std::string(text.substr(0, 64)) +
                     "'; choose extrapolate, clamp, reflect, periodic or none (or two of them, "
                     "x then y, as in periodic,clamp)");
}

Boundaries parse_boundaries(std::string_view text) {
  const auto comma = text.find(',');
  if (comma == std::string_view::npos) {
    const Boundary both = parse_boundary(text);
    return {both, both};
  }
  return {parse_boundary(text.substr(0, comma)), parse_boundary(text.substr(comma + 1))};
}

std::string_view to_string(Boundary boundary) {
  for (const auto& [name, value] : names)
    if (value == boundary) return name;
  return "";
}

Continuation continued(Boundary boundary, Index index, Index count) {
  if (index >= 0 && index < count) return {index, index, 0};
  if (count == 1) return {0, 0, 0};
  const Index last = count - 1;
  switch (boundary) {
    case Boundary::extrapolate:
      return index < 0 ? Continuation{0, 1, -index} : Continuation{last, last - 1, index - last};
    case Boundary::reflect: {
      const Index folded = modulo(index, 2 * last);
      const Index inside = folded <= last ? folded : 2 * last - folded;
      return {inside, inside, 0};
    }
    case Boundary::periodic: {
      const Index inside = modulo(index, count);
      return {inside, inside, 0};
    }
    case Boundary::clamp:
    case Boundary::none:
      break;
  }
  const Index end = index < 0 ? 0 : last;
  return {end, end, 0};
}

}  // namespace arete

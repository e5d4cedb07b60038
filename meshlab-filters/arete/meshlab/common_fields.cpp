// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/common_fields.h"

namespace arete::meshlab {
namespace {

// Scripts use the number.
constexpr Boundary boundaries[] = {Boundary::extrapolate, Boundary::clamp, Boundary::reflect,
                                   Boundary::periodic, Boundary::none};

}  // namespace

const std::string& citation() {
  static const std::string text =
      "<br>See: <i>H. Zhao, X. Peng, Z. Ye</i>, <b>\"Improved four points subdivision "
      "scheme\"</b>; <i>N. Dyn, D. Levin</i>, <b>\"Subdivision schemes in geometric "
      "modelling\"</b>, Acta Numerica 11, 2002.<br>";
  return text;
}

const std::string& what_is_a_grid() {
  static const std::string text =
      "The mesh must be a regular grid: quads, or triangles two to a cell, with any diagonals, "
      "in any order and anywhere in space; several separate grids are taken one by one. ";
  return text;
}

const std::string& layer_matrix() {
  static const std::string text =
      "Works in the layer's own coordinates; the layer's matrix is neither read nor changed.";
  return text;
}

Field boundary_field(Boundary last) {
  std::string tooltip =
      "How heights go on beyond the rim. extrapolate: linearly, planes stay planes; clamp: the "
      "rim's height; reflect: mirrored";
  std::vector<std::string> choices;
  for (Boundary boundary : boundaries) {
    choices.emplace_back(to_string(boundary));
    if (boundary == Boundary::periodic)
      tooltip += "; periodic: those of the other side (heights only)";
    if (boundary == Boundary::none) tooltip += "; none: not at all, the mesh loses its rim";
    if (boundary == last) break;
  }
  return choice_field("Boundary", "Beyond the rim", tooltip, choices);
}

Field coordinates_field() {
  return choice_field("Coordinates", "Apply to",
                      "heights: only z, while x and y stay on straight lines between the old "
                      "vertices (for terrain); x, y and z: the whole surface",
                      {"heights (z)", "x, y and z"});
}

Field quads_field(bool fallback) {
  return flag_field("KeepQuads", "Make quads",
                    "Mark the result as a mesh of quads (the diagonals are not drawn), otherwise "
                    "as triangles",
                    fallback);
}

Boundary chosen_boundary(const Values& values) { return boundaries[values.whole("Boundary")]; }

Coordinates chosen_coordinates(const Values& values) {
  return values.whole("Coordinates") == 0 ? Coordinates::heights : Coordinates::all;
}

}  // namespace arete::meshlab

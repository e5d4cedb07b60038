// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/filter_table.h"

#include "arete/meshlab/limit_surface.h"
#include "arete/meshlab/scheme_fields.h"
#include "arete/meshlab/smoothness_report.h"
#include "arete/meshlab/subdivide.h"

namespace arete::meshlab {
namespace {

const std::string citation =
    "<br>See: <i>H. Zhao, X. Peng, Z. Ye</i>, <b>\"Improved four points subdivision scheme\"</b>; "
    "<i>N. Dyn, D. Levin</i>, <b>\"Subdivision schemes in geometric modelling\"</b>, Acta Numerica "
    "11, 2002.<br>";

const std::string what_is_a_grid =
    "The mesh must be a regular grid: quads, or triangles two to a cell, with any diagonals, "
    "in any order and anywhere in space; several separate grids are refined one by one. ";

const std::string layer_matrix =
    "Works in the layer's own coordinates; the layer's matrix is neither read nor changed.";

// The order of arete::Boundary; scripts use the number.
constexpr Boundary boundaries[] = {Boundary::extrapolate, Boundary::clamp, Boundary::reflect,
                                   Boundary::periodic, Boundary::none};

Field boundary_field(int count) {
  std::vector<std::string> choices;
  for (int i = 0; i < count; ++i) choices.emplace_back(to_string(boundaries[i]));
  return choice_field(
      "Boundary", "Beyond the rim",
      std::string("How heights go on beyond the rim. extrapolate: linearly, planes stay planes; "
                  "clamp: the rim's height; reflect: mirrored; periodic: those of the other side "
                  "(heights only)") +
          (count == 5 ? "; none: not at all, the mesh loses its rim" : ""),
      choices);
}

Field coordinates_field() {
  return choice_field("Coordinates", "Apply to",
                      "heights: only z, while x and y stay on straight lines between the old "
                      "vertices (for terrain); x, y and z: the whole surface is smoothed",
                      {"heights (z)", "x, y and z"});
}

Boundary chosen_boundary(const Values& values) { return boundaries[values.whole("Boundary")]; }

Coordinates chosen_coordinates(const Values& values) {
  return values.whole("Coordinates") == 0 ? Coordinates::heights : Coordinates::all;
}

Filter subdivide_filter() {
  return {
      "Arete: Subdivide Terrain Grid",
      "Refines a terrain grid by a parametric subdivision scheme, from gentle to craggy. " +
          what_is_a_grid +
          "Old vertices keep their numbers and attributes; colour, quality and texture coordinates "
          "of new ones are interpolated, and texture seams survive. Samples of dual and asymmetric "
          "schemes are placed where they lie, so that the mountain does not move. " +
          layer_matrix + citation,
      remeshing | polygonal,
      Effect::replaces,
      [](const MeshFacts& facts) {
        std::vector<Field> fields = scheme_fields();
        fields.push_back(whole_field(
            "Levels", "Levels",
            "How often the mesh is refined; every level makes about 4 times as many faces "
            "(ternary schemes 9 times, ternary-two-step-9 81 times)",
            facts.vertices > 100000 ? 1 : 2, 1, 10));
        fields.push_back(boundary_field(5));
        fields.push_back(coordinates_field());
        fields.push_back(flag_field("KeepQuads", "Make quads",
                                    "Mark the result as a mesh of quads (the diagonals are not "
                                    "drawn), otherwise as triangles",
                                    facts.polygonal));
        return fields;
      },
      [](const MeshArrays& mesh, const Values& values, Report& report) {
        SubdivideOptions options;
        options.levels = values.whole("Levels");
        options.boundary = chosen_boundary(values);
        options.coordinates = chosen_coordinates(values);
        Outcome outcome;
        outcome.refined = subdivided(mesh, chosen_scheme(values), options, report);
        outcome.keep_quads = values.flag("KeepQuads");
        return outcome;
      }};
}

Filter limit_filter() {
  return {"Arete: Compute Limit Positions And Normals",
          "Moves every vertex of a terrain grid to where infinitely many levels of subdivision "
          "would bring it, and gives it the exact normal of the limit surface there (where the "
          "scheme is proved to be C<sup>1</sup>). " +
              what_is_a_grid + layer_matrix + citation,
          normal | remeshing,
          Effect::moves,
          [](const MeshFacts&) {
            std::vector<Field> fields = scheme_fields();
            fields.push_back(boundary_field(4));
            fields.push_back(coordinates_field());
            return fields;
          },
          [](const MeshArrays& mesh, const Values& values, Report& report) {
            SubdivideOptions options;
            options.boundary = chosen_boundary(values);
            options.coordinates = chosen_coordinates(values);
            Outcome outcome;
            outcome.moved = moved_to_limit(mesh, chosen_scheme(values), options, report);
            return outcome;
          }};
}

Filter smoothness_filter() {
  return {"Arete: Smoothness To Log",
          "Writes to the log what a subdivision scheme is worth: how smooth its surfaces are, with "
          "the proof (certified, refuted or undecided for every order), the Hoelder exponent, "
          "which polynomials it keeps, and what published theorems say. The mesh is not touched." +
              citation,
          measure | remeshing,
          Effect::reports,
          [](const MeshFacts&) {
            std::vector<Field> fields = scheme_fields();
            fields.push_back(whole_field("MaxPower", "Largest power",
                                         "Up to which power of the scheme a proof is searched; "
                                         "larger finds more and takes longer",
                                         8, 1, 12));
            return fields;
          },
          [](const MeshArrays&, const Values& values, Report& report) {
            report_smoothness(chosen_scheme(values), values.whole("MaxPower"), report);
            return Outcome{};
          }};
}

}  // namespace

const std::vector<Filter>& filter_table() {
  static const std::vector<Filter> table{subdivide_filter(), limit_filter(), smoothness_filter()};
  return table;
}

}  // namespace arete::meshlab

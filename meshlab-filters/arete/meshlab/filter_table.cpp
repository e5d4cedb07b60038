// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/filter_table.h"

#include <limits>

#include "arete/meshlab/common_fields.h"
#include "arete/meshlab/layer_filters.h"
#include "arete/meshlab/limit_surface.h"
#include "arete/meshlab/scheme_fields.h"
#include "arete/meshlab/smoothness_report.h"
#include "arete/meshlab/subdivide.h"

namespace arete::meshlab {
namespace {

Filter subdivide_filter() {
  return {
      "Arete: Subdivide Terrain Grid",
      "Refines a terrain grid by a parametric subdivision scheme, from gentle to craggy. " +
          what_is_a_grid() +
          "Old vertices keep their numbers and attributes; colour, quality and texture coordinates "
          "of new ones are interpolated, and texture seams survive. Samples of dual and asymmetric "
          "schemes are placed where they lie, so that the mountain does not move. " +
          layer_matrix() + citation(),
      remeshing | polygonal,
      Effect::replaces,
      [](const MeshFacts& facts) {
        std::vector<Field> fields = scheme_fields();
        fields.push_back(whole_field(
            "Levels", "Levels",
            "How often the mesh is refined; every level makes about 4 times as many faces "
            "(ternary schemes 9 times, ternary-two-step-9 81 times)",
            facts.vertices > 100000 ? 1 : 2, 1, 10));
        fields.push_back(boundary_field(Boundary::none));
        fields.push_back(coordinates_field());
        fields.push_back(number_field(
            "DetailAmount", "Detail amount",
            "Random detail for the heights, added level by level: its deviation at the first level "
            "as a share of the local relief, so that plains stay plain. 0: none; 0.15 suits "
            "mountains",
            0, 0, 10));
        fields.push_back(number_field("DetailRoughness", "Detail roughness",
                                      "Hurst exponent of the detail: 0 is raw, 2 smooth; terrain "
                                      "mostly 0.5 to 0.9",
                                      0.5, 0, 2));
        fields.push_back(whole_field("Seed", "Detail seed",
                                     "Another seed, another surface of the same character", 0, 0,
                                     std::numeric_limits<int>::max()));
        fields.push_back(quads_field(facts.polygonal));
        return fields;
      },
      [](const MeshArrays& mesh, const Values& values, Report& report) {
        SubdivideOptions options;
        options.levels = values.whole("Levels");
        options.boundary = chosen_boundary(values);
        options.coordinates = chosen_coordinates(values);
        if (const double amount = values.number("DetailAmount"); amount > 0) {
          options.detail.emplace();
          options.detail->relief = amount;
          options.detail->roughness = values.number("DetailRoughness");
          options.detail->seed = static_cast<std::uint64_t>(values.whole("Seed"));
        }
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
              what_is_a_grid() + layer_matrix() + citation(),
          normal | remeshing,
          Effect::moves,
          [](const MeshFacts&) {
            std::vector<Field> fields = scheme_fields();
            fields.push_back(boundary_field(Boundary::periodic));
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
              citation(),
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
  static const std::vector<Filter> table{subdivide_filter(), limit_filter(), smoothness_filter(),
                                         coarsen_filter(),
#ifdef ARETE_MESHLAB_WITH_CGAL
                                         points_filter()
#endif
  };
  return table;
}

}  // namespace arete::meshlab

// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/layer_filters.h"

#include "arete/meshlab/coarsen.h"
#include "arete/meshlab/common_fields.h"
#include "arete/meshlab/scheme_fields.h"

namespace arete::meshlab {

Filter coarsen_filter() {
  return {
      "Arete: Coarsen Terrain Grid (reverse subdivision)",
      "Makes a new layer with the coarse terrain grid whose subdivision comes nearest to this one: "
      "the inverse of <i>Arete: Subdivide Terrain Grid</i>, better than taking every second "
      "vertex. " +
          what_is_a_grid() +
          "The old layer stays; on request its vertex quality becomes what the coarse terrain, "
          "refined again, misses there. Colour, quality and texture coordinates are taken over. " +
          layer_matrix() +
          "<br>See: <i>F. Samavati, R. Bartels</i>, <b>\"Multiresolution curve and surface "
          "representation: reversing subdivision rules by least-squares data fitting\"</b>, "
          "Computer Graphics Forum 18, 1999.<br>",
      remeshing | polygonal,
      Effect::creates,
      [](const MeshFacts& facts) {
        std::vector<Field> fields = scheme_fields();
        fields.push_back(whole_field("Levels", "Levels",
                                     "How often the mesh is coarsened; every level leaves about a "
                                     "quarter of the faces (ternary schemes a ninth)",
                                     1, 1, 10));
        fields.push_back(boundary_field(Boundary::reflect));
        fields.push_back(coordinates_field());
        fields.push_back(choice_field(
            "Mode", "Coarse vertices by",
            "least squares: the best ones, for every scheme; short filters: from a few vertices "
            "around, faster but rougher, for interpolating schemes, chaikin, de-rham and the "
            "quadratic and cubic b-spline",
            {"least squares", "short filters"}));
        fields.push_back(quads_field(facts.polygonal));
        fields.push_back(flag_field(
            "DetailsToQuality", "Details to quality",
            "Replace the vertex quality of this layer by what the coarse terrain misses at every "
            "vertex: its height above the coarse terrain refined again (with x, y and z: the "
            "distance). 'Colorize by vertex quality' then shows it",
            false));
        return fields;
      },
      [](const MeshArrays& mesh, const Values& values, Report& report) {
        CoarsenOptions options;
        options.levels = values.whole("Levels");
        options.boundary = chosen_boundary(values);
        options.coordinates = chosen_coordinates(values);
        options.mode = values.whole("Mode") == 0 ? ReverseMode::least_squares : ReverseMode::local;
        Coarsened result = coarsened(mesh, chosen_scheme(values), options, report);
        Outcome outcome;
        outcome.created = std::move(result.mesh);
        outcome.keep_quads = values.flag("KeepQuads");
        if (values.flag("DetailsToQuality")) outcome.quality = std::move(result.details);
        return outcome;
      }};
}

}  // namespace arete::meshlab

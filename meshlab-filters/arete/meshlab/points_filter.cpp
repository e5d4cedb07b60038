// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "arete/meshlab/common_fields.h"
#include "arete/meshlab/layer_filters.h"
#include "arete/meshlab/terrain_from_points.h"

namespace arete::meshlab {
namespace {

// Scripts use the numbers.
constexpr std::optional<cgal::GridMethod> methods[] = {
    cgal::GridMethod::natural_neighbour, cgal::GridMethod::linear,
    cgal::GridMethod::inverse_distance, std::nullopt};
constexpr int linear = 1;
constexpr int own_triangles = 3;
constexpr cgal::OutsideHull outsides[] = {
    cgal::OutsideHull::nearest, cgal::OutsideHull::extrapolate, cgal::OutsideHull::nodata};

// As many vertices as there are points, if these are spread evenly.
double even_spacing(const MeshFacts& facts) {
  if (facts.vertices < 1) return 0.01;
  const double spacing = std::sqrt(facts.width * facts.height / facts.vertices);
  return spacing > 0 ? spacing : 0.01;
}

std::vector<Field> point_fields(const MeshFacts& facts) {
  return {
      length_field(
          "Spacing", "Spacing",
          "How far the vertices of the new grid lie apart along x and y. The default makes "
          "about as many as there are points; a coarser grid is a better control grid for "
          "Arete: Subdivide Terrain Grid",
          even_spacing(facts), facts.diagonal > 0 ? facts.diagonal : 1),
      choice_field("Method", "Heights by",
                   "natural neighbour: smooth, through every point, for sparse surveys without "
                   "noise (slopes "
                   "between noisy neighbours make it overshoot); linear: on the Delaunay triangles "
                   "of the points; inverse distance: weighted mean of the nearest points; own "
                   "triangles: on the triangles that the mesh has (a TIN with its breaklines)",
                   {"natural neighbour", "linear", "inverse distance", "own triangles"},
                   facts.faces ? own_triangles : linear),
      choice_field(
          "Outside", "Outside the points",
          "The corners of the grid that lie outside the points. nearest: the height at the "
          "nearest place of their hull; extrapolate: along the slope there; left out: the "
          "terrain has gaps and cannot be subdivided",
          {"nearest", "extrapolate", "left out"}),
      number_field("DropOutliers", "Drop outliers",
                   "Drop points further than this many standard deviations from the plane through "
                   "their neighbours; 0: all points count. Not read by own triangles",
                   0, 0, 1000),
      quads_field(true)};
}

}  // namespace

Filter points_filter() {
  return {"Arete: Terrain From Points",
          "Makes a new layer with a regular terrain grid from a point cloud, or from any terrain "
          "mesh (TIN): the control grid that <i>Arete: Subdivide Terrain Grid</i> refines. Heights "
          "are z over x and y; the old layer stays. Colour and quality come along. " +
              layer_matrix() +
              "<br>See: <i>R. Sibson</i>, <b>\"A brief description of natural neighbour "
              "interpolation\"</b>, in Interpreting Multivariate Data, 1981.<br>",
          remeshing | point_set | sampling,
          Effect::creates,
          point_fields,
          [](const MeshArrays& mesh, const Values& values, Report& report) {
            FromPointsOptions options;
            options.spacing = values.number("Spacing");
            options.method = methods[values.whole("Method")];
            options.outside = outsides[values.whole("Outside")];
            options.drop_outliers = values.number("DropOutliers");
            Outcome outcome;
            outcome.created = terrain_from_points(mesh, options, report);
            outcome.keep_quads = values.flag("KeepQuads");
            return outcome;
          },
          false};
}

}  // namespace arete::meshlab

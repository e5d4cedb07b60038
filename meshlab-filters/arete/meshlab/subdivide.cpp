// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/subdivide.h"

#include <string>

#include "arete/field/at.h"
#include "arete/meshlab/memory.h"
#include "arete/meshlab/plane_refiner.h"
#include "arete/meshlab/refined_patch.h"
#include "arete/meshlab/surface_patch.h"

namespace arete::meshlab {
namespace {

struct PatchPlan {
  AxisPlan x;
  AxisPlan y;
};

PatchPlan planned(const GridPatch& patch, const Scheme& scheme, const SubdivideOptions& options) {
  const bool open = !patch.wraps_rows || !patch.wraps_cols;
  if (open && options.boundary == Boundary::periodic && options.coordinates == Coordinates::all)
    throw InvalidField(
        "boundary periodic would bend x and y of an open rim to the other side; use "
        "it for heights only, or choose another boundary");
  const auto axis = [&](Index count, bool wraps) {
    AxisOptions axis_options;
    axis_options.levels = options.levels;
    axis_options.boundary = wraps ? Boundary::periodic : options.boundary;
    return AxisPlan(scheme.mask(), count, axis_options);
  };
  return {axis(patch.extent.cols, patch.wraps_cols), axis(patch.extent.rows, patch.wraps_rows)};
}

// What MeshLab and these arrays need for every new vertex and its two triangles.
double bytes_per_vertex(const MeshArrays& mesh) {
  return 310 + 8.0 * static_cast<double>(mesh.channels.size()) + (mesh.wedges.empty() ? 0 : 150);
}

void check_size(const std::vector<PatchPlan>& plans, const MeshArrays& mesh) {
  double vertices = 0;
  for (const PatchPlan& plan : plans)
    vertices +=
        static_cast<double>(plan.x.output_count()) * static_cast<double>(plan.y.output_count());
  check_memory(vertices * bytes_per_vertex(mesh), vertices);
}

class Subdivision {
 public:
  Subdivision(const MeshArrays& mesh, const SubdivideOptions& options, const Report& report)
      : mesh_(mesh),
        options_(options),
        report_(report),
        next_vertex_(static_cast<int>(mesh.positions.size())) {
    result_.arrays.positions = mesh.positions;
    result_.arrays.channels = mesh.channels;
  }

  void add(const GridPatch& patch, const PatchPlan& plan, int begin, int end) {
    const RefinedPatch refined(patch, AxisSamples(plan.y, patch.wraps_rows),
                               AxisSamples(plan.x, patch.wraps_cols), next_vertex_);
    result_.dropped_vertices.insert(result_.dropped_vertices.end(), refined.dropped().begin(),
                                    refined.dropped().end());
    result_.arrays.positions.resize(at(next_vertex_));
    const int middle = begin + (end - begin) * 2 / 3;
    refine_positions(refined, plan, begin, middle);
    report_.progress(middle, "Interpolating attributes");
    for (std::size_t k = 0; k < mesh_.channels.size(); ++k) blend_channel(refined, k);
    report_.progress(end, "Making faces");
    refined.append_faces(mesh_, result_);
  }

  [[nodiscard]] RefinedMesh take() { return std::move(result_); }

 private:
  void refine_positions(const RefinedPatch& refined, const PatchPlan& plan, int begin, int end) {
    const std::size_t first = options_.coordinates == Coordinates::all ? 0 : 2;
    for (std::size_t k = 0; k < first; ++k) {
      const auto old = [&](int v) { return mesh_.positions[at(v)][k]; };
      for_each(refined, [&](Index r, Index c, int v) {
        result_.arrays.positions[at(v)][k] = blended(refined.old(), old, refined.place(r, c));
      });
    }
    const int share = (end - begin) / static_cast<int>(3 - first);
    for (std::size_t k = first; k < 3; ++k) {
      const int start = begin + share * static_cast<int>(k - first);
      const Refiner<double> refiner(plan.x, plan.y, 0, k == 2 ? options_.detail : std::nullopt);
      const Grid<double> fine = refined_plane(refiner, coordinate_plane(mesh_, refined.old(), k),
                                              report_, start, start + share);
      for_each(refined, [&](Index r, Index c, int v) {
        result_.arrays.positions[at(v)][k] =
            fine(refined.rows().samples()[at(r)].result, refined.cols().samples()[at(c)].result);
      });
    }
  }

  void blend_channel(const RefinedPatch& refined, std::size_t k) {
    std::vector<float>& fine = result_.arrays.channels[k].values;
    fine.resize(at(next_vertex_));
    for_each(refined, [&](Index r, Index c, int v) {
      fine[at(v)] = carried(refined.old(), mesh_.channels[k], refined.place(r, c));
    });
  }

  static void for_each(const RefinedPatch& refined, const auto& action) {
    const Extent extent = refined.extent();
    for (Index r = 0; r < extent.rows; ++r)
      for (Index c = 0; c < extent.cols; ++c) action(r, c, refined.vertex(r, c));
  }

  const MeshArrays& mesh_;
  const SubdivideOptions& options_;
  const Report& report_;
  int next_vertex_;
  RefinedMesh result_;
};

std::string size_text(Extent extent) {
  return std::to_string(extent.rows) + " x " + std::to_string(extent.cols);
}

}  // namespace

RefinedMesh subdivided(const MeshArrays& mesh, const Scheme& scheme,
                       const SubdivideOptions& options, Report& report) {
  report.progress(0, "Finding the rows and columns of the mesh");
  const std::vector<GridPatch> patches = surface_patches(mesh, report);
  std::vector<PatchPlan> plans;
  for (const GridPatch& patch : patches) plans.push_back(planned(patch, scheme, options));
  check_size(plans, mesh);

  Subdivision subdivision(mesh, options, report);
  const auto percent = [&](std::size_t patch) {
    return 20 + static_cast<int>(60 * patch / patches.size());
  };
  for (std::size_t i = 0; i < patches.size(); ++i)
    subdivision.add(patches[i], plans[i], percent(i), percent(i + 1));
  RefinedMesh result = subdivision.take();

  report.log("Scheme " + scheme.text());
  if (options.detail && options.detail->relief > 0)
    report.log("Detail of " + std::to_string(options.detail->relief) +
               " of the local relief, roughness " + std::to_string(options.detail->roughness) +
               ", seed " + std::to_string(options.detail->seed));
  if (patches.size() == 1)
    report.log("Refined a grid of " + size_text(patches[0].extent) + " vertices " +
               std::to_string(options.levels) + (options.levels == 1 ? " time" : " times"));
  else
    report.log("Refined " + std::to_string(patches.size()) + " separate grids");
  report.log("The mesh now has " +
             std::to_string(result.arrays.positions.size() - result.dropped_vertices.size()) +
             " vertices and " + std::to_string(result.arrays.triangles.size()) + " triangles");
  return result;
}

}  // namespace arete::meshlab

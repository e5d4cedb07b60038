// SPDX-License-Identifier: MIT
#include "arete/openmesh/reverse_mesh.h"

#include <cmath>

#include "arete/openmesh/internal/attribute_bytes.h"
#include "arete/openmesh/internal/plain_mesh.h"
#include "arete/reverse/grid_mesh.h"

namespace arete::openmesh {
namespace {

double longest(const MeshLevels& levels) {
  double longest = 0;
  for (const auto& level : levels)
    for (Index i = 0; i < level.details.rows(); ++i)
      longest = std::max(longest,
                         std::hypot(level.details(i, 0), level.details(i, 1), level.details(i, 2)));
  return longest;
}

// Of every level; nothing for schemes for meshes.
std::vector<std::shared_ptr<const GridStep>> grid_steps(const MeshDetailsFile& details) {
  std::vector<std::shared_ptr<const GridStep>> steps(details.levels.size());
  if (!details.grid || steps.empty()) return steps;
  steps.front() = std::make_shared<const GridStep>(*details.grid);
  for (std::size_t i = 1; i < steps.size(); ++i)
    steps[i] = std::make_shared<const GridStep>(steps[i - 1]->coarser());
  return steps;
}

}  // namespace

CoarsenedMesh coarsen_mesh(const MeshData& mesh, const MeshCoarsenOptions& options) {
  if (!(options.threshold.value_or(0) >= 0 && options.target_rmse.value_or(0) >= 0))
    throw InvalidField("a threshold or target RMSE must be 0 or more, in units of the mesh");
  const MeshFaces faces = mesh_faces(static_cast<Index>(mesh.points.size()), mesh.faces);
  const Grid<double> positions = detail::positions_of(mesh);
  MeshLevels levels = options.grid_scheme
                          ? decompose_grid_mesh(faces, positions.view(), *options.grid_scheme,
                                                options.boundaries, options.mode, options.levels)
                          : decompose_mesh_levels(faces, positions.view(),
                                                  candidate_rules(options.scheme, options.rim),
                                                  options.mode, options.levels);
  CoarsenedMesh result;
  result.rule = levels.empty() ? MeshRule(options.scheme, options.rim.value_or(MeshRim::smooth))
                               : levels.front().rule;
  result.largest_detail = longest(levels);
  result.threshold = options.threshold.value_or(0);
  if (options.target_rmse)
    result.threshold = threshold_for_rmse(levels, positions.view(), *options.target_rmse);
  if (options.lossy()) drop_details(levels, result.threshold);
  result.count = count_details(levels);
  if (!levels.empty())
    result.error = restore_error(reconstruct_mesh_levels(levels), positions.view());

  MeshDetailsFile& file = result.details;
  file.rule = result.rule;
  if (!levels.empty() && levels.front().mesh.grid) file.grid = *levels.front().mesh.grid;
  file.mode = options.mode;
  file.lossy = options.lossy();
  result.coarse = mesh;
  file.attributes = detail::attribute_names(mesh);
  for (auto& step : levels) {
    result.unique = result.unique && step.unique;
    MeshLevelDetails level{step.mesh.place,
                           step.mesh.faces,
                           std::move(step.details),
                           file.lossy ? Grid<double>() : std::move(step.remainder),
                           {}};
    detail::split_attributes(result.coarse, detail::attribute_split(step.mesh, result.rule.scheme),
                             level);
    file.levels.push_back(std::move(level));
  }
  if (!levels.empty()) {
    detail::set_points(result.coarse, levels.back().coarse);
    result.coarse.faces = face_list(levels.back().mesh.coarse);
  }
  file.coarse_faces = checksum(levels.empty() ? faces : levels.back().mesh.coarse);
  file.coarse_positions = checksum((levels.empty() ? positions : levels.back().coarse).samples());
  return result;
}

MeshData restore_mesh(const MeshData& coarse, const MeshDetailsFile& details, int levels,
                      bool edited) {
  if (levels < 0 || static_cast<std::size_t>(levels) > details.levels.size())
    throw InvalidField("there are " + std::to_string(details.levels.size()) +
                       " levels of details, not " + std::to_string(levels));
  MeshData mesh = coarse;
  MeshFaces faces = mesh_faces(static_cast<Index>(mesh.points.size()), mesh.faces);
  Grid<double> positions = detail::positions_of(mesh);
  if (checksum(faces) != details.coarse_faces) detail::foreign("checksum of its faces");
  if (!edited && checksum(positions.samples()) != details.coarse_positions)
    detail::foreign(
        "checksum of its positions; if it was changed on purpose, say that it is edited");
  try {
    const auto grids = grid_steps(details);
    for (std::size_t i = details.levels.size(); i-- > details.levels.size() - levels;) {
      const MeshLevelDetails& level = details.levels[i];
      MeshDecomposition<double> step{
          details.rule,
          {std::move(faces), level.place, level.faces, grids[i]},
          {},
          level.details,
          details.lossy ? Grid<double>(level.details.extent()) : level.remainder,
          true};
      positions = reconstruct_mesh<double>(step, std::as_const(positions).view());
      faces = refined_faces(step.mesh, details.rule.scheme);
      detail::join_attributes(mesh, detail::attribute_split(step.mesh, details.rule.scheme),
                              details.attributes, level);
    }
  } catch (const InvalidField& error) {
    throw InvalidDetails(std::string("the details do not fit the coarse mesh: ") + error.what() +
                         "; make them again");
  }
  detail::set_points(mesh, positions);
  mesh.faces = face_list(faces);
  return mesh;
}

}  // namespace arete::openmesh

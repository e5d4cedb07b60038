// SPDX-License-Identifier: MIT
#pragma once

#include <optional>

#include "arete/openmesh/mesh_io.h"
#include "arete/reverse/mesh_details_file.h"
#include "arete/reverse/mesh_levels.h"

namespace arete::openmesh {

/// How coarsen_mesh() undoes subdivision.
struct MeshCoarsenOptions {
  MeshScheme scheme = MeshScheme::catmull_clark;
  std::optional<MeshRim> rim;  ///< nothing: the one with the smallest details
  ReverseMode mode = ReverseMode::least_squares;
  int levels = 1;
  /// Details no longer than this are dropped; or as many as the RMSE of target_rmse allows. Not
  /// both.
  std::optional<double> threshold;
  std::optional<double> target_rmse;
  /// Set: the mesh is a grid and this scheme of the catalogue is undone, with these boundaries
  /// (decompose_grid_mesh); `scheme` and `rim` do not matter then.
  std::optional<Scheme> grid_scheme = {};
  Boundaries boundaries = {};

  [[nodiscard]] bool lossy() const {
    return threshold.value_or(0) > 0 || target_rmse.value_or(0) > 0;
  }
};

/// A mesh taken apart.
struct CoarsenedMesh {
  MeshData coarse;
  MeshDetailsFile details;  ///< what restore_mesh() needs beside the coarse mesh
  MeshRule rule = MeshScheme::catmull_clark;
  bool unique = true;  ///< see MeshCoarse; of all levels
  DetailCount count;
  double threshold = 0;       ///< that was applied
  RestoreError error;         ///< of the mesh as it will be restored
  double largest_detail = 0;  ///< rounding when the mesh was subdivided by this scheme
};

/// Undoes subdivision steps of a mesh in plain arrays; see decompose_mesh and mesh_attributes.h.
/// Without a threshold the details give back every bit: positions, the order of vertices and faces,
/// colours and texture coordinates.
/// \throws InvalidField where the mesh has no subdivision structure or is no manifold.
[[nodiscard]] CoarsenedMesh coarsen_mesh(const MeshData& mesh, const MeshCoarsenOptions& options);

/// Puts the coarsest `levels` levels back. With `edited` the coarse vertices may have been moved:
/// the details are then laid over them; faces must be as they were.
/// \throws InvalidDetails if the coarse mesh is not the one that the details belong to;
/// InvalidField if there are not that many levels.
[[nodiscard]] MeshData restore_mesh(const MeshData& coarse, const MeshDetailsFile& details,
                                    int levels, bool edited = false);

}  // namespace arete::openmesh

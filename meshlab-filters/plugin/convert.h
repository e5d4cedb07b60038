// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "arete/meshlab/mesh_arrays.h"
#include "compat.h"

namespace arete::meshlab {

/// The live vertices and faces of a mesh as plain arrays, in their order, with whatever optional
/// components are there: colour, quality, texture coordinates and radius of vertices as channels,
/// texture coordinates of wedges. The mesh is not changed.
[[nodiscard]] MeshArrays read_mesh(const MeshModel& mesh);

/// Puts the result in place of the mesh it was made from. Deleted elements are compacted away,
/// vertices keep numbers, flags and attributes; colour, quality and selection of a face go to all
/// that lie in its place; adjacency and curvature, which are no longer true, are switched off.
void write_refined(const RefinedMesh& refined, bool keep_quads, MeshModel& mesh);

/// Fills a new mesh beside the one it was made from: kinds of attributes, textures and the layer's
/// matrix are taken over. The mesh must be empty.
void write_created(const CreatedMesh& created, bool keep_quads, const MeshModel& source,
                   MeshModel& mesh);

/// Replaces the quality of the live vertices.
void write_quality(const std::vector<float>& quality, MeshModel& mesh);

/// Puts new places (and normals) in; nothing else changes.
void write_moved(const MovedMesh& moved, MeshModel& mesh);

}  // namespace arete::meshlab

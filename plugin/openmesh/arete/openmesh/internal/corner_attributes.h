// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <set>
#include <vector>

#include "arete/openmesh/internal/vertex_attributes.h"

namespace arete::openmesh::detail {

/// Half-edge properties that are numbers or vectors belong to corners of faces (OpenMesh keeps the
/// value of a corner at the half-edge that ends there): a new corner gets the value its place has
/// in the old face that holds the middle of its cell, bilinear in quads and linear in triangles. So
/// a seam stays a seam and linear values stay exact. Half-edges without a face get zeros; normals
/// are made unit length again.
[[nodiscard]] std::vector<Job> corner_jobs(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild,
                                           const std::set<const OpenMesh::BaseProperty*>& skipped);

}  // namespace arete::openmesh::detail

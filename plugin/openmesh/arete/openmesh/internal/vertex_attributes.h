// SPDX-License-Identifier: MIT
#pragma once

#include <OpenMesh/Core/Mesh/ArrayKernel.hh>
#include <functional>
#include <memory>
#include <set>
#include <vector>

#include "arete/openmesh/internal/vertex_values.h"

namespace arete::openmesh::detail {

/// What is left to do for a property once the mesh has its new elements.
using Job = std::function<void()>;

/// The job for a property of a type only the mesh's traits know; empty if it is none of those.
using TraitsJob =
    std::function<Job(OpenMesh::BaseProperty& property, AttributeRule rule, ValueRange range)>;

/// Takes the old values of every vertex property but those in `skipped` and returns what refines
/// them. Properties whose values are no numbers are refined at once, to the nearest old vertex.
/// The arguments must outlive the jobs.
[[nodiscard]] std::vector<Job> vertex_jobs(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild,
                                           const std::vector<PatchEvaluator<double>>& evaluators,
                                           const AttributeRules& rules,
                                           const std::set<const OpenMesh::BaseProperty*>& skipped,
                                           const TraitsJob& traits);

/// The range colours of a property are held in: 0..255 where they are integers, otherwise 0..1 or
/// what the old ones span beyond.
[[nodiscard]] ValueRange color_range(OpenMesh::BaseProperty& old);

}  // namespace arete::openmesh::detail

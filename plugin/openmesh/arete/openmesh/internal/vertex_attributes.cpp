// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/vertex_attributes.h"

#include <OpenMesh/Core/Mesh/Status.hh>

#include "arete/openmesh/internal/gather.h"
#include "arete/openmesh/internal/known_types.h"

namespace arete::openmesh::detail {
namespace {

using OpenMesh::BaseProperty;
using OpenMesh::PropertyT;
using OpenMesh::Attributes::StatusInfo;

AttributeRule rule_of(const std::string& name, const AttributeRules& rules) {
  const auto named = rules.by_name.find(name);
  if (named != rules.by_name.end()) return named->second;
  if (name.rfind("v:texcoords", 0) == 0) return rules.texcoords;
  if (name == "v:colors") return rules.colors;
  return rules.custom;
}

// For every new vertex the nearest old one.
std::vector<int> nearest_vertices(const Rebuild& rebuild) {
  std::vector<int> nearest(static_cast<std::size_t>(rebuild.vertices), -1);
  for (const RefinedPatch& patch : rebuild.patches) {
    std::vector<int> vertices(static_cast<std::size_t>(patch.cols.fine()));
    for (Index r = 0; r < patch.rows.fine(); ++r) {
      patch.row_vertices(r, vertices);
      const Index row =
          patch.rows.samples[static_cast<std::size_t>(r)].nearest(patch.rows.coarse());
      for (std::size_t c = 0; c < vertices.size(); ++c)
        nearest[static_cast<std::size_t>(vertices[c])] =
            patch.coarse.vertex(row, patch.cols.samples[c].nearest(patch.cols.coarse()));
    }
  }
  for (const auto& [old_number, new_number] : rebuild.lone_vertices)
    nearest[static_cast<std::size_t>(new_number)] = old_number;
  return nearest;
}

// A new vertex has the flags that all old vertices around it have: the two ends of the edge it lies
// on, the four corners of the cell, or just the vertex it coincides with.
void refine_status(const Rebuild& rebuild, const std::vector<StatusInfo>& old,
                   std::vector<StatusInfo>& values) {
  const auto ends = [](const Location& place, const RefinedAxis& axis) {
    const Index next = (place.cell + 1) % axis.coarse();
    if (place.sample < 0) return std::pair(place.cell, next);
    return std::pair(place.sample % axis.coarse(), place.sample % axis.coarse());
  };
  for (const RefinedPatch& patch : rebuild.patches) {
    std::vector<int> vertices(static_cast<std::size_t>(patch.cols.fine()));
    for (Index r = 0; r < patch.rows.fine(); ++r) {
      patch.row_vertices(r, vertices);
      const auto [top, bottom] = ends(patch.rows.samples[static_cast<std::size_t>(r)], patch.rows);
      for (std::size_t c = 0; c < vertices.size(); ++c) {
        const auto [left, right] = ends(patch.cols.samples[c], patch.cols);
        const auto bits = [&](Index i, Index j) {
          return old[static_cast<std::size_t>(patch.coarse.vertex(i, j))].bits();
        };
        values[static_cast<std::size_t>(vertices[c])].set_bits(
            bits(top, left) & bits(top, right) & bits(bottom, left) & bits(bottom, right));
      }
    }
  }
  for (const auto& [old_number, new_number] : rebuild.lone_vertices)
    values[static_cast<std::size_t>(new_number)] = old[static_cast<std::size_t>(old_number)];
}

}  // namespace

ValueRange color_range(BaseProperty& old) {
  ValueRange range{0, 1};
  KnownTypes::visit(old, [&]<class T>(PropertyT<T>& property) {
    using C = Components<T>;
    if constexpr (std::is_integral_v<typename C::Scalar>) {
      range.highest = 255;
    }
    for (const T& value : property.data_vector()) {
      for (std::size_t k = 0; k < C::count; ++k) {
        const auto x = static_cast<double>(C::get(value, k));
        if (x < range.lowest) range.lowest = x;
        if (x > range.highest) range.highest = x;
      }
    }
  });
  return range;
}

std::vector<Job> vertex_jobs(OpenMesh::ArrayKernel& mesh, const Rebuild& rebuild,
                             const std::vector<PatchEvaluator<double>>& evaluators,
                             const AttributeRules& rules,
                             const std::set<const BaseProperty*>& skipped,
                             const TraitsJob& traits) {
  std::vector<Job> jobs;
  std::vector<int> nearest;
  for (auto it = mesh.vprops_begin(); it != mesh.vprops_end(); ++it) {
    BaseProperty* const property = *it;
    if (!property || skipped.count(property) != 0) continue;
    if (auto* status = dynamic_cast<PropertyT<StatusInfo>*>(property)) {
      jobs.push_back([&rebuild, status, old = status->data_vector()] {
        refine_status(rebuild, old, status->data_vector());
      });
      continue;
    }
    const AttributeRule rule = rule_of(property->name(), rules);
    const ValueRange range = property->name() == "v:colors" ? color_range(*property) : ValueRange{};
    if (rule != AttributeRule::nearest) {
      const bool known = KnownTypes::visit(*property, [&]<class T>(PropertyT<T>& typed) {
        jobs.push_back([&rebuild, &evaluators, &typed, rule, range, old = typed.data_vector()] {
          refine_vertex_values(rebuild, evaluators, rule, range, old, typed.data_vector());
        });
      });
      if (known) continue;
      if (Job job = traits(*property, rule, range)) {
        jobs.push_back(std::move(job));
        continue;
      }
    }
    if (nearest.empty()) nearest = nearest_vertices(rebuild);
    gather(*property, nearest);
  }
  return jobs;
}

}  // namespace arete::openmesh::detail

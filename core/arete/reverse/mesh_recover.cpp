// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_recover.h"

#include "arete/reverse/mesh_draft.h"

namespace arete {

std::vector<RecoveredMesh> recover_coarse(const MeshFaces& fine, MeshScheme scheme,
                                          std::string* reason) {
  const MeshNeighbours mesh(fine);
  const auto parts = connected_faces(fine).size();
  if (parts != 1)
    throw InvalidField("the mesh has " + std::to_string(parts) +
                       " connected parts; reverse them one by one");
  recovery::Obstacle obstacle;
  std::vector<RecoveredMesh> found;
  switch (scheme) {
    case MeshScheme::catmull_clark:
      found = recovery::catmull_clark(fine, mesh, obstacle);
      break;
    case MeshScheme::loop:
    case MeshScheme::loop_warren:
      found = recovery::loop(fine, mesh, obstacle);
      break;
    case MeshScheme::doo_sabin:
      found = recovery::doo_sabin(fine, mesh, obstacle);
  }
  if (reason) *reason = obstacle.text();
  return found;
}

MeshFaces refined_faces(const RecoveredMesh& mesh, MeshScheme scheme) {
  const MeshFaces step = mesh.step_faces(scheme);
  if (mesh.place.size() != static_cast<std::size_t>(step.vertices) ||
      mesh.faces.size() != step.faces.size())
    throw InvalidField("the coarse mesh refines to " + std::to_string(step.vertices) +
                       " vertices and " + std::to_string(step.faces.size()) + " faces, not " +
                       std::to_string(mesh.place.size()) + " and " +
                       std::to_string(mesh.faces.size()));
  MeshFaces fine{step.vertices, {}};
  for (const auto& [number, turn] : mesh.faces) {
    std::vector<Index> face = step.faces.at(static_cast<std::size_t>(number));
    for (Index& v : face) v = mesh.place.at(static_cast<std::size_t>(v));
    if (turn < 0 || turn >= static_cast<Index>(face.size()))
      throw InvalidField("a face of " + std::to_string(face.size()) +
                         " corners cannot begin at corner " + std::to_string(turn));
    std::rotate(face.begin(), face.begin() + turn, face.end());
    fine.faces.push_back(std::move(face));
  }
  return fine;
}

}  // namespace arete

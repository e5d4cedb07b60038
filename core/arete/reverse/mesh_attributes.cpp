// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_attributes.h"

namespace arete {
namespace {

// The chosen first, in their order, then the rest of 0..count-1.
std::vector<Index> chosen_first(std::vector<Index> chosen, Index count) {
  std::vector<std::uint8_t> taken(static_cast<std::size_t>(count), 0);
  for (const Index i : chosen) taken[static_cast<std::size_t>(i)] = 1;
  for (Index i = 0; i < count; ++i)
    if (taken[static_cast<std::size_t>(i)] == 0) chosen.push_back(i);
  return chosen;
}

// Where mesh_step puts the faces of a coarse face: the one at its corner i is first + i (Doo-Sabin:
// the face itself).
std::vector<Index> first_faces(const MeshFaces& coarse, MeshScheme scheme) {
  std::vector<Index> first;
  Index count = 0;
  for (const auto& face : coarse.faces) {
    first.push_back(count);
    count += scheme == MeshScheme::doo_sabin
                 ? 1
                 : static_cast<Index>(face.size()) + (MeshRule(scheme).triangles() ? 1 : 0);
  }
  return first;
}

std::vector<Index> inverse(const std::vector<RecoveredMesh::FacePlace>& faces) {
  std::vector<Index> given(faces.size());
  for (std::size_t f = 0; f < faces.size(); ++f)
    given[static_cast<std::size_t>(faces[f].face)] = static_cast<Index>(f);
  return given;
}

}  // namespace

std::vector<Index> vertex_order(const RecoveredMesh& mesh, MeshScheme scheme) {
  const auto count = static_cast<Index>(mesh.place.size());
  std::vector<Index> chosen(static_cast<std::size_t>(mesh.coarse.vertices), -1);
  if (scheme == MeshScheme::doo_sabin && !mesh.grid) {
    std::size_t corner = 0;
    for (const auto& face : mesh.coarse.faces)
      for (const Index v : face) {
        Index& own = chosen[static_cast<std::size_t>(v)];
        if (own < 0) own = mesh.place[corner];
        ++corner;
      }
  } else {
    std::copy_n(mesh.place.begin(), chosen.size(), chosen.begin());
  }
  return chosen_first(std::move(chosen), count);
}

std::vector<Index> corner_order(const RecoveredMesh& mesh, MeshScheme scheme) {
  const std::vector<Index> given = inverse(mesh.faces);
  const std::vector<Index> first =
      mesh.grid ? mesh.grid->corner_faces() : first_faces(mesh.coarse, scheme);
  // Sizes of the given faces, and where their corners begin.
  const MeshFaces fine = refined_faces(mesh, scheme);
  std::vector<Index> start{0};
  for (const auto& face : fine.faces)
    start.push_back(start.back() + static_cast<Index>(face.size()));
  // Corner k of the step's face is corner (k - turn) of the given one.
  const auto corner = [&](Index step_face, Index k) {
    const Index g = given[static_cast<std::size_t>(step_face)];
    const Index size = start[static_cast<std::size_t>(g) + 1] - start[static_cast<std::size_t>(g)];
    const Index turn = mesh.faces[static_cast<std::size_t>(g)].turn;
    return start[static_cast<std::size_t>(g)] + (k - turn + size) % size;
  };
  std::vector<Index> chosen;
  for (std::size_t f = 0; f < mesh.coarse.faces.size(); ++f)
    for (Index i = 0; i < static_cast<Index>(mesh.coarse.faces[f].size()); ++i)
      chosen.push_back(mesh.grid ? corner(first[4 * f + static_cast<std::size_t>(i)], i)
                       : scheme == MeshScheme::doo_sabin ? corner(first[f], i)
                                                         : corner(first[f] + i, 0));
  return chosen_first(std::move(chosen), start.back());
}

std::vector<Index> face_heirs(const RecoveredMesh& mesh, MeshScheme scheme) {
  const std::vector<Index> given = inverse(mesh.faces);
  std::vector<Index> heirs;
  if (mesh.grid) {
    const std::vector<Index> corners = mesh.grid->corner_faces();
    for (std::size_t i = 0; i < corners.size(); i += 4)
      heirs.push_back(given[static_cast<std::size_t>(corners[i])]);
    return heirs;
  }
  for (const Index first : first_faces(mesh.coarse, scheme))
    heirs.push_back(given[static_cast<std::size_t>(first)]);
  return heirs;
}

}  // namespace arete

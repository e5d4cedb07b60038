// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_recover.h"

#include "arete/reverse/mesh_draft.h"

namespace arete {
namespace {

template <class R>
R squared(const Grid<R>& grid) {
  R sum(0);
  for (const R& value : grid.samples()) sum = sum + value * value;
  return sum;
}

template <class R>
Grid<R> subdivided(const RecoveredMesh& mesh, MeshScheme scheme, const Grid<R>& coarse) {
  const MeshStep<R> step = mesh_step<R>(mesh.coarse, scheme);
  Grid<R> fine({step.s.rows(), coarse.cols()});
  step.s.multiply({coarse.row(0), coarse.rows(), coarse.cols(), coarse.cols()},
                  {fine.row(0), fine.rows(), fine.cols(), fine.cols()});
  Grid<R> placed(fine.extent());
  for (Index i = 0; i < fine.rows(); ++i)
    std::copy_n(fine.row(i), fine.cols(), placed.row(mesh.place[static_cast<std::size_t>(i)]));
  return placed;
}

const char* structure_of(MeshScheme scheme) {
  if (scheme == MeshScheme::catmull_clark)
    return "Catmull-Clark (quads, each between a vertex, two edge points and a face point)";
  if (scheme == MeshScheme::loop) return "Loop (triangles in fours)";
  return "Doo-Sabin (faces, edges and vertices by turns around vertices of valence 4)";
}

}  // namespace

std::vector<RecoveredMesh> recover_coarse(const MeshFaces& fine, MeshScheme scheme) {
  const MeshNeighbours mesh(fine);
  const auto parts = connected_faces(fine).size();
  if (parts != 1)
    throw InvalidField("the mesh has " + std::to_string(parts) +
                       " connected parts; reverse them one by one");
  switch (scheme) {
    case MeshScheme::catmull_clark:
      return recovery::catmull_clark(fine, mesh);
    case MeshScheme::loop:
      return recovery::loop(fine, mesh);
    case MeshScheme::doo_sabin:
      break;
  }
  return recovery::doo_sabin(fine, mesh);
}

template <class R>
MeshDecomposition<R> decompose_mesh(const MeshFaces& fine, GridView<const R> positions,
                                    MeshScheme scheme, ReverseMode mode) {
  if (positions.rows() != fine.vertices || positions.cols() < 1)
    throw InvalidField("there are " + std::to_string(positions.rows()) + " positions for " +
                       std::to_string(fine.vertices) + " vertices");
  std::optional<MeshDecomposition<R>> best;
  for (RecoveredMesh& mesh : recover_coarse(fine, scheme)) {
    Grid<R> ordered(positions.extent());
    for (Index i = 0; i < positions.rows(); ++i)
      std::copy_n(positions.row(mesh.place[static_cast<std::size_t>(i)]), positions.cols(),
                  ordered.row(i));
    MeshCoarse<R> coarse =
        reverse_mesh_step<R>(mesh.coarse, scheme, std::as_const(ordered).view(), mode);
    Grid<R> details = subdivided(mesh, scheme, coarse.positions);
    for (Index i = 0; i < details.rows(); ++i)
      for (Index c = 0; c < details.cols(); ++c) details(i, c) = positions(i, c) - details(i, c);
    if (best && !(squared(details) < squared(best->details))) continue;
    best = MeshDecomposition<R>{scheme, std::move(mesh), std::move(coarse.positions),
                                std::move(details), coarse.unique};
  }
  if (!best)
    throw InvalidField(std::string("the mesh does not have the structure of ") +
                       structure_of(scheme) + "; only subdivided meshes can be reversed");
  return std::move(*best);
}

template <class R>
Grid<R> reconstruct_mesh(const MeshDecomposition<R>& parts) {
  Grid<R> fine = subdivided(parts.mesh, parts.scheme, parts.coarse);
  for (Index i = 0; i < fine.rows(); ++i)
    for (Index c = 0; c < fine.cols(); ++c) fine(i, c) = fine(i, c) + parts.details(i, c);
  return fine;
}

template MeshDecomposition<double> decompose_mesh(const MeshFaces&, GridView<const double>,
                                                  MeshScheme, ReverseMode);
template MeshDecomposition<Rational> decompose_mesh(const MeshFaces&, GridView<const Rational>,
                                                    MeshScheme, ReverseMode);
template Grid<double> reconstruct_mesh(const MeshDecomposition<double>&);
template Grid<Rational> reconstruct_mesh(const MeshDecomposition<Rational>&);

}  // namespace arete

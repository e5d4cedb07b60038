// SPDX-License-Identifier: MIT
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

#include "arete/reverse/mesh_draft.h"

namespace arete {
namespace {

template <class R>
R squared(GridView<const R> numbers) {
  R sum(0);
  for (Index i = 0; i < numbers.rows(); ++i)
    for (Index c = 0; c < numbers.cols(); ++c) sum = sum + numbers(i, c) * numbers(i, c);
  return sum;
}

// Details so small that they are rounding: no other candidate can do better.
template <class R>
bool vanish(const R& details, const R& positions) {
  if constexpr (std::is_floating_point_v<R>)
    return details <= positions * R(1e-22);
  else
    return details == R(0);
}

// In the order of the step.
template <class R>
Grid<R> step_positions(const RecoveredMesh& mesh, MeshRule rule, GridView<const R> coarse) {
  if (mesh.grid) {
    if constexpr (std::is_same_v<R, double>) return mesh.grid->subdivided(coarse);
    throw InvalidField("grids are put together in floating point only");
  }
  const MeshStep<R> step = mesh_step<R>(mesh.coarse, rule);
  Grid<R> fine({step.s.rows(), coarse.cols()});
  step.s.multiply({coarse.row(0), coarse.rows(), coarse.cols(), coarse.stride()},
                  {fine.row(0), fine.rows(), fine.cols(), fine.cols()});
  return fine;
}

template <class R>
Grid<R> subdivided(const RecoveredMesh& mesh, MeshRule rule, GridView<const R> coarse) {
  const Grid<R> fine = step_positions<R>(mesh, rule, coarse);
  if (static_cast<Index>(mesh.place.size()) != fine.rows())
    throw InvalidField("there are places of " + std::to_string(mesh.place.size()) +
                       " vertices where the coarse mesh refines to " + std::to_string(fine.rows()));
  Grid<R> placed(fine.extent());
  for (Index i = 0; i < fine.rows(); ++i)
    std::copy_n(fine.row(i), fine.cols(), placed.row(mesh.place[static_cast<std::size_t>(i)]));
  return placed;
}

// to = a - b, number by number.
template <class R>
void subtract(GridView<const R> a, const Grid<R>& b, Grid<R>& to) {
  for (Index i = 0; i < to.rows(); ++i)
    for (Index c = 0; c < to.cols(); ++c) to(i, c) = a(i, c) - b(i, c);
}
template <class R>
void add(Grid<R>& to, const Grid<R>& more) {
  for (std::size_t i = 0; i < to.samples().size(); ++i)
    to.samples()[i] = to.samples()[i] + more.samples()[i];
}

template <class R>
void add_details(MeshDecomposition<R>& parts, GridView<const R> positions) {
  Grid<R> again = subdivided<R>(parts.mesh, parts.rule, std::as_const(parts.coarse).view());
  parts.details = Grid<R>(positions.extent());
  parts.remainder = Grid<R>(positions.extent());
  subtract(positions, again, parts.details);
  add(again, parts.details);
  subtract(positions, again, parts.remainder);
}

template <class R>
MeshDecomposition<R> with_details(MeshRule rule, RecoveredMesh mesh, GridView<const R> positions,
                                  ReverseMode mode) {
  Grid<R> ordered(positions.extent());
  for (Index i = 0; i < positions.rows(); ++i)
    std::copy_n(positions.row(mesh.place[static_cast<std::size_t>(i)]), positions.cols(),
                ordered.row(i));
  MeshCoarse<R> coarse =
      reverse_mesh_step<R>(mesh.coarse, rule, std::as_const(ordered).view(), mode);
  MeshDecomposition<R> parts{rule, std::move(mesh), std::move(coarse.positions), {},
                             {},   coarse.unique};
  add_details(parts, positions);
  return parts;
}

[[noreturn]] void refuse(MeshScheme scheme, const std::string& reason) {
  const char* structure = "Doo-Sabin (faces, edges and vertices by turns around every vertex)";
  if (scheme == MeshScheme::catmull_clark)
    structure = "Catmull-Clark (quads, each between a vertex, two edge points and a face point)";
  if (MeshRule(scheme).triangles()) structure = "Loop (triangles in fours)";
  throw InvalidField(std::string("the mesh does not have the structure of ") + structure +
                     (reason.empty() ? "" : ": " + reason) +
                     "; only subdivided meshes can be reversed");
}

template <class R>
Grid<R> rows_of(GridView<const R> from, const std::vector<Index>& rows) {
  Grid<R> chosen({static_cast<Index>(rows.size()), from.cols()});
  for (std::size_t i = 0; i < rows.size(); ++i)
    std::copy_n(from.row(rows[i]), from.cols(), chosen.row(static_cast<Index>(i)));
  return chosen;
}

// Where the runs of mesh_step's fine vertices end: vertex, face and edge points, or corners alone.
std::array<Index, 3> fine_runs(const MeshFaces& coarse, MeshScheme scheme) {
  constexpr Index endless = std::numeric_limits<Index>::max();
  if (scheme == MeshScheme::doo_sabin) return {endless, endless, endless};
  const auto faces =
      scheme == MeshScheme::catmull_clark ? static_cast<Index>(coarse.faces.size()) : Index{0};
  return {coarse.vertices, coarse.vertices + faces, endless};
}

// Among the candidate meshes and rules of a connected mesh, for each rule the best mesh.
template <class R>
std::vector<MeshDecomposition<R>> best_of_each_rule(const MeshFaces& fine,
                                                    GridView<const R> positions,
                                                    const std::vector<MeshRule>& rules,
                                                    ReverseMode mode, bool stop_early) {
  std::string reason;
  const auto candidates = recover_coarse(fine, rules.front().scheme, &reason);
  if (candidates.empty()) refuse(rules.front().scheme, reason);
  const R whole = squared(positions);
  std::vector<MeshDecomposition<R>> found;
  for (const MeshRule& rule : rules) {
    std::optional<MeshDecomposition<R>> best;
    R least(0);
    for (const RecoveredMesh& mesh : candidates) {
      auto parts = with_details<R>(rule, mesh, positions, mode);
      const R size = squared(std::as_const(parts.details).view());
      if (best && !(size < least)) continue;
      best = std::move(parts);
      least = size;
      if (vanish(least, whole)) break;
    }
    found.push_back(std::move(*best));
    if (stop_early && vanish(least, whole)) break;
  }
  return found;
}

// Part of a mesh with vertices of its own.
struct Part {
  MeshFaces mesh;
  std::vector<Index> vertices;  // of the whole
};

std::vector<Part> parts_of(const MeshFaces& mesh) {
  std::vector<Part> parts;
  std::vector<Index> number(static_cast<std::size_t>(mesh.vertices), -1);
  for (const auto& faces : connected_faces(mesh)) {
    Part part;
    for (const Index f : faces) {
      std::vector<Index> face = mesh.faces[static_cast<std::size_t>(f)];
      for (Index& v : face) {
        Index& own = number[static_cast<std::size_t>(v)];
        if (own < 0) {
          own = part.mesh.vertices++;
          part.vertices.push_back(v);
        }
        v = own;
      }
      part.mesh.faces.push_back(std::move(face));
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

// mesh_step numbers vertex points, then face points, then edge points, or corners alone, each
// part after part when the coarse vertices and faces are: so the parts' runs are laid end to end.
template <class R>
MeshDecomposition<R> joined(const MeshFaces& fine, const std::vector<Part>& parts,
                            const std::vector<MeshDecomposition<R>>& pieces, Index columns) {
  const Extent extent{fine.vertices, columns};
  MeshDecomposition<R> whole{pieces.front().rule, {}, {}, Grid<R>(extent), Grid<R>(extent), true};
  Index coarse_rows = 0;
  for (const auto& piece : pieces) coarse_rows += piece.coarse.rows();
  whole.coarse = Grid<R>({coarse_rows, columns});
  std::array<std::vector<Index>, 3> runs;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const MeshDecomposition<R>& piece = pieces[p];
    const auto& vertices = parts[p].vertices;
    Index& first = whole.mesh.coarse.vertices;
    whole.unique = whole.unique && piece.unique;
    for (Index i = 0; i < piece.coarse.rows(); ++i)
      std::copy_n(piece.coarse.row(i), columns, whole.coarse.row(first + i));
    for (Index i = 0; i < piece.details.rows(); ++i) {
      const Index row = vertices[static_cast<std::size_t>(i)];
      std::copy_n(piece.details.row(i), columns, whole.details.row(row));
      std::copy_n(piece.remainder.row(i), columns, whole.remainder.row(row));
    }
    const auto run_ends = fine_runs(piece.mesh.coarse, whole.rule.scheme);
    std::size_t run = 0;
    for (std::size_t i = 0; i < piece.mesh.place.size(); ++i) {
      while (static_cast<Index>(i) >= run_ends[run]) ++run;
      runs[run].push_back(vertices[static_cast<std::size_t>(piece.mesh.place[i])]);
    }
    for (auto face : piece.mesh.coarse.faces) {
      for (Index& v : face) v += first;
      whole.mesh.coarse.faces.push_back(std::move(face));
    }
    first += piece.mesh.coarse.vertices;
  }
  for (const auto& run : runs)
    whole.mesh.place.insert(whole.mesh.place.end(), run.begin(), run.end());
  (void)recovery::fits(fine, whole.mesh, whole.rule.scheme);
  return whole;
}

}  // namespace

void recovery::set_details(MeshDecomposition<double>& parts, GridView<const double> positions) {
  add_details(parts, positions);
}

std::vector<MeshRule> candidate_rules(MeshScheme scheme, std::optional<MeshRim> rim) {
  if (rim) return {{scheme, *rim}};
  if (scheme == MeshScheme::doo_sabin) return {scheme};
  return {{scheme, MeshRim::smooth}, {scheme, MeshRim::sharp_corners}, {scheme, MeshRim::thirds}};
}

template <class R>
MeshDecomposition<R> decompose_mesh(const MeshFaces& fine, GridView<const R> positions,
                                    const std::vector<MeshRule>& rules, ReverseMode mode) {
  if (positions.rows() != fine.vertices || positions.cols() < 1)
    throw InvalidField("there are " + std::to_string(positions.rows()) + " positions for " +
                       std::to_string(fine.vertices) + " vertices");
  const MeshNeighbours neighbours(fine);
  bool open = false;
  for (Index e = 0; e < neighbours.edge_count() && !open; ++e) open = neighbours.boundary_edge(e);
  // Without a rim all rims are one.
  const std::vector<MeshRule> tried(rules.begin(), open ? rules.end() : rules.begin() + 1);
  const std::vector<Part> parts = parts_of(fine);
  std::vector<std::vector<MeshDecomposition<R>>> found;  // for each part, for each rule
  for (const Part& part : parts) {
    if (parts.size() == 1) {
      found.push_back(best_of_each_rule<R>(fine, positions, tried, mode, true));
      break;
    }
    const Grid<R> own = rows_of(positions, part.vertices);
    found.push_back(best_of_each_rule<R>(part.mesh, std::as_const(own).view(), tried, mode, false));
  }
  std::size_t best = 0;
  std::optional<R> least;
  for (std::size_t k = 0; k < found.front().size(); ++k) {
    R sum(0);
    for (const auto& of_part : found) sum = sum + squared(std::as_const(of_part[k].details).view());
    if (least && !(sum < *least)) continue;
    least = sum;
    best = k;
  }
  if (parts.size() == 1) return std::move(found.front()[best]);
  std::vector<MeshDecomposition<R>> pieces;
  for (auto& of_part : found) pieces.push_back(std::move(of_part[best]));
  return joined(fine, parts, pieces, positions.cols());
}

template <class R>
Grid<R> reconstruct_mesh(const MeshDecomposition<R>& parts, GridView<const R> coarse) {
  if (coarse.rows() != parts.mesh.coarse.vertices || coarse.cols() != parts.details.cols())
    throw InvalidField("there are " + std::to_string(coarse.rows()) + " coarse vertices where " +
                       std::to_string(parts.mesh.coarse.vertices) + " belong");
  Grid<R> fine = subdivided(parts.mesh, parts.rule, coarse);
  if (fine.extent() != parts.details.extent() || fine.extent() != parts.remainder.extent())
    throw InvalidField("there are details of " + std::to_string(parts.details.rows()) +
                       " vertices where the coarse mesh refines to " + std::to_string(fine.rows()));
  add(fine, parts.details);
  add(fine, parts.remainder);
  return fine;
}

template MeshDecomposition<double> decompose_mesh(const MeshFaces&, GridView<const double>,
                                                  const std::vector<MeshRule>&, ReverseMode);
template MeshDecomposition<Rational> decompose_mesh(const MeshFaces&, GridView<const Rational>,
                                                    const std::vector<MeshRule>&, ReverseMode);
template Grid<double> reconstruct_mesh(const MeshDecomposition<double>&, GridView<const double>);
template Grid<Rational> reconstruct_mesh(const MeshDecomposition<Rational>&,
                                         GridView<const Rational>);

}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_reverse.h"

#include <Eigen/SparseCholesky>
#include <numeric>

#include "arete/reverse/normal_equations.h"

namespace arete {
namespace {

constexpr const char* undetermined =
    "the fine points do not determine the coarse vertices; the mesh has no reverse";

template <class R>
void add_row(Grid<R>& to, Index row, GridView<const R> from, Index from_row, const R& weight) {
  add_line(to.row(row), from.row(from_row), weight, to.cols());
}

template <class R>
class LocalMeshReverse {
 public:
  LocalMeshReverse(const MeshFaces& coarse, MeshRule rule, GridView<const R> fine)
      : faces_(coarse),
        mesh_(coarse),
        rule_(rule),
        fine_(fine),
        result_({coarse.vertices, fine.cols()}),
        first_face_(coarse.vertices),
        first_edge_(coarse.vertices + (rule.scheme == MeshScheme::catmull_clark
                                           ? static_cast<Index>(coarse.faces.size())
                                           : 0)) {}

  // Nothing if some vertices cannot be reached by the formulas.
  std::optional<Grid<R>> run() {
    if (rule_.scheme == MeshScheme::doo_sabin) return doo_sabin();
    std::vector<std::uint8_t> known(static_cast<std::size_t>(faces_.vertices), 0);
    for (Index v = 0; v < faces_.vertices; ++v) {
      const auto n = static_cast<Index>(mesh_.vertex_edges(v).size());
      if (mesh_.on_boundary(v)) {
        boundary_vertex(v);
      } else if (rule_.triangles()) {
        inner_vertex(v, loop_reverse<R>(n, loop_beta<R>(rule_.scheme, n)));
      } else if (n != 3) {
        inner_vertex(v, catmull_clark_reverse<R>(n));
      } else {
        continue;
      }
      known[static_cast<std::size_t>(v)] = 1;
    }
    return propagate(known) ? std::optional(std::move(result_)) : std::nullopt;
  }

 private:
  void inner_vertex(Index v, const VertexReverse<R>& weights) {
    add_row(result_, v, fine_, v, weights.vertex);
    for (const Index e : mesh_.vertex_edges(v))
      add_row(result_, v, fine_, first_edge_ + e, weights.edge);
    if (weights.face == R(0)) return;
    for (const Index f : mesh_.vertex_faces(v))
      add_row(result_, v, fine_, first_face_ + f, weights.face);
  }

  // v' = (1 - 2w) V + w (A + B) and e = (V + A)/2: v' = (1 - 4w) V + 2w (e_1 + e_2).
  void boundary_vertex(Index v) {
    const R beside = rim_weight<R>(rule_.rim, mesh_.vertex_faces(v).size());
    const R over = R(1) / (R(1) - R(4) * beside);
    add_row(result_, v, fine_, v, over);
    for (const Index e : mesh_.vertex_edges(v))
      if (mesh_.boundary_edge(e))
        add_row(result_, v, fine_, first_edge_ + e, R(-2) * beside * over);
  }

  // Sweeps in ascending order; within one a vertex already found serves the next.
  bool propagate(std::vector<std::uint8_t>& known) {
    for (;;) {
      bool found = false;
      bool left = false;
      for (Index v = 0; v < faces_.vertices; ++v) {
        if (known[static_cast<std::size_t>(v)] != 0) continue;
        left = true;
        std::vector<Index> served;
        for (const Index e : mesh_.vertex_edges(v))
          if (known[static_cast<std::size_t>(mesh_.other_end(e, v))] != 0) served.push_back(e);
        if (served.empty()) continue;
        const R share = R(1) / R(static_cast<int>(served.size()));
        for (const Index e : served) {
          add_row(result_, v, fine_, first_edge_ + e, R(4) * share);
          add_row(result_, v, std::as_const(result_).view(), mesh_.other_end(e, v), R(0) - share);
          for (const Index f : mesh_.edge_faces(e))
            add_row(result_, v, fine_, first_face_ + f, R(0) - share);
        }
        known[static_cast<std::size_t>(v)] = 1;
        found = true;
      }
      if (!left) return true;
      if (!found) return false;
    }
  }

  Grid<R> doo_sabin() {
    Index first = 0;
    for (const auto& face : faces_.faces) {
      const auto n = static_cast<Index>(face.size());
      for (Index i = 0; i < n; ++i) {
        const Index v = face[static_cast<std::size_t>(i)];
        const R share = R(1) / R(static_cast<int>(mesh_.vertex_faces(v).size()));
        for (Index j = 0; j < n; ++j)
          add_row(result_, v, fine_, first + j, doo_sabin_inverse<R>(i - j, n) * share);
      }
      first += n;
    }
    return std::move(result_);
  }

  const MeshFaces& faces_;
  MeshNeighbours mesh_;
  MeshRule rule_;
  GridView<const R> fine_;
  Grid<R> result_;
  Index first_face_;
  Index first_edge_;
};

// x with S^T S x = S^T fine, a fill-reducing sparse factorisation: exact fields take the envelope.
Grid<double> solved(const SparseRows<double>& s, GridView<const double> fine) {
  using Sparse = Eigen::SparseMatrix<double>;
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < s.rows(); ++i)
    for (const auto& [col, weight] : s.row(i))
      entries.emplace_back(static_cast<int>(i), static_cast<int>(col), weight);
  Sparse matrix(s.rows(), s.cols());
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Sparse gram = Sparse(matrix.transpose()) * matrix;
  const Eigen::SimplicialLDLT<Sparse> solver(gram);
  if (solver.info() != Eigen::Success ||
      !(solver.vectorD().minCoeff() > 1e-14 * solver.vectorD().maxCoeff()))
    throw InvalidField(undetermined);
  Grid<double> result({s.cols(), fine.cols()});
  for (Index c = 0; c < fine.cols(); ++c) {
    Eigen::VectorXd column(fine.rows());
    for (Index i = 0; i < fine.rows(); ++i) column(i) = fine(i, c);
    const Eigen::VectorXd x = solver.solve(matrix.transpose() * column);
    for (Index i = 0; i < result.rows(); ++i) result(i, c) = x(i);
  }
  return result;
}

Grid<Rational> solved(const SparseRows<Rational>& s, GridView<const Rational> fine) {
  const NormalEquations<Rational> solver(s, s.transposed());
  if (solver.dependent_column()) throw InvalidField(undetermined);
  Grid<Rational> result({s.cols(), fine.cols()});
  const Lines<Rational> lines{result.row(0), result.rows(), result.cols(), result.cols()};
  solver.solve({fine.row(0), fine.rows(), fine.cols(), fine.stride()}, lines);
  return result;
}

// Of a pattern that no fine point shows: one vertex is held at 0, then the part along the pattern
// is taken out, which leaves the solution of least norm.
template <class R>
Grid<R> least_squares(const SparseRows<R>& s, GridView<const R> fine,
                      const std::vector<std::vector<int>>& patterns) {
  std::vector<std::uint8_t> held(static_cast<std::size_t>(s.cols()), 0);
  for (const auto& pattern : patterns)
    held[static_cast<std::size_t>(
        std::find_if(pattern.begin(), pattern.end(), [](int sign) { return sign != 0; }) -
        pattern.begin())] = 1;
  std::vector<Index> place(static_cast<std::size_t>(s.cols()), -1);
  std::vector<Index> order;
  for (Index v = 0; v < s.cols(); ++v) {
    if (held[static_cast<std::size_t>(v)] != 0) continue;
    place[static_cast<std::size_t>(v)] = static_cast<Index>(order.size());
    order.push_back(v);
  }
  SparseRows<R> reduced(static_cast<Index>(order.size()));
  for (Index i = 0; i < s.rows(); ++i) {
    typename SparseRows<R>::Row row;
    for (const auto& entry : s.row(i))
      if (place[static_cast<std::size_t>(entry.col)] >= 0)
        row.push_back({place[static_cast<std::size_t>(entry.col)], entry.weight});
    reduced.push_row(std::move(row));
  }
  const Grid<R> solution = solved(reduced, fine);
  Grid<R> result({s.cols(), fine.cols()});
  for (std::size_t i = 0; i < order.size(); ++i)
    std::copy_n(solution.row(static_cast<Index>(i)), fine.cols(), result.row(order[i]));
  for (const auto& pattern : patterns) {
    const auto length = static_cast<Index>(
        std::count_if(pattern.begin(), pattern.end(), [](int sign) { return sign != 0; }));
    for (Index c = 0; c < result.cols(); ++c) {
      R along(0);
      for (Index v = 0; v < result.rows(); ++v)
        along = along + R(pattern[static_cast<std::size_t>(v)]) * result(v, c);
      along = along / R(static_cast<int>(length));
      for (Index v = 0; v < result.rows(); ++v)
        result(v, c) = result(v, c) - R(pattern[static_cast<std::size_t>(v)]) * along;
    }
  }
  return result;
}

}  // namespace

std::vector<std::vector<int>> invisible_patterns(const MeshFaces& coarse, MeshScheme scheme) {
  std::vector<std::vector<int>> found;
  if (scheme != MeshScheme::catmull_clark) return found;
  const MeshNeighbours mesh(coarse);
  std::vector<int> sign(static_cast<std::size_t>(coarse.vertices), 0);
  for (Index start = 0; start < coarse.vertices; ++start) {
    if (sign[static_cast<std::size_t>(start)] != 0) continue;
    std::vector<Index> part{start};
    sign[static_cast<std::size_t>(start)] = 1;
    bool alternating = true;
    for (std::size_t i = 0; i < part.size(); ++i) {
      const Index v = part[i];
      if (mesh.on_boundary(v) || mesh.vertex_edges(v).size() != 3) alternating = false;
      for (const Index e : mesh.vertex_edges(v)) {
        const Index neighbour = mesh.other_end(e, v);
        int& other = sign[static_cast<std::size_t>(neighbour)];
        if (other == 0) {
          other = -sign[static_cast<std::size_t>(v)];
          part.push_back(neighbour);
        } else if (other == sign[static_cast<std::size_t>(v)]) {
          alternating = false;
        }
      }
    }
    if (!alternating) continue;
    std::vector<int> pattern(sign.size(), 0);
    for (const Index v : part)
      pattern[static_cast<std::size_t>(v)] = sign[static_cast<std::size_t>(v)];
    found.push_back(std::move(pattern));
  }
  return found;
}

template <class R>
MeshCoarse<R> reverse_mesh_step(const MeshFaces& coarse, MeshRule rule, GridView<const R> fine,
                                ReverseMode mode) {
  const MeshStep<R> step = mesh_step<R>(coarse, rule);
  if (fine.rows() != step.s.rows())
    throw InvalidField("there are " + std::to_string(fine.rows()) +
                       " fine points where the mesh "
                       "refines to " +
                       std::to_string(step.s.rows()));
  const auto patterns = invisible_patterns(coarse, rule.scheme);
  if (mode == ReverseMode::local) {
    auto found = LocalMeshReverse<R>(coarse, rule, fine).run();
    if (found) return {std::move(*found), true};
  }
  return {least_squares(step.s, fine, patterns), patterns.empty()};
}

template MeshCoarse<double> reverse_mesh_step(const MeshFaces&, MeshRule, GridView<const double>,
                                              ReverseMode);
template MeshCoarse<Rational> reverse_mesh_step(const MeshFaces&, MeshRule,
                                                GridView<const Rational>, ReverseMode);

}  // namespace arete

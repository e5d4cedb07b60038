// SPDX-License-Identifier: MIT
#include "arete/reverse/mesh_step.h"

namespace arete {
namespace {

template <class R>
using Row = typename SparseRows<R>::Row;

template <class R>
R quotient(int p, Index q) {
  return R(p) / R(static_cast<int>(q));
}

// A vertex and its two neighbours along the boundary.
template <class R>
Row<R> boundary_vertex(const MeshNeighbours& mesh, Index v, MeshRim rim) {
  const R beside = rim_weight<R>(rim, mesh.vertex_faces(v).size());
  Row<R> row{{v, R(1) - R(2) * beside}};
  for (const Index e : mesh.vertex_edges(v))
    if (mesh.boundary_edge(e)) row.push_back({mesh.other_end(e, v), beside});
  return row;
}

template <class R>
void add_centre(Row<R>& row, const std::vector<Index>& face, const R& weight) {
  for (const Index v : face) row.push_back({v, weight / R(static_cast<int>(face.size()))});
}

template <class R>
MeshStep<R> catmull_clark(const MeshFaces& coarse, MeshRim rim) {
  const MeshNeighbours mesh(coarse);
  const auto face = [&](Index f) -> const std::vector<Index>& {
    return coarse.faces[static_cast<std::size_t>(f)];
  };
  SparseRows<R> s(coarse.vertices);
  for (Index v = 0; v < coarse.vertices; ++v) {
    if (mesh.on_boundary(v)) {
      s.push_row(boundary_vertex<R>(mesh, v, rim));
      continue;
    }
    const auto n = static_cast<Index>(mesh.vertex_edges(v).size());
    Row<R> row{{v, quotient<R>(static_cast<int>(n - 2), n)}};
    for (const Index e : mesh.vertex_edges(v))
      row.push_back({mesh.other_end(e, v), quotient<R>(1, n * n)});
    for (const Index f : mesh.vertex_faces(v)) add_centre(row, face(f), quotient<R>(1, n * n));
    s.push_row(std::move(row));
  }
  for (const auto& corners : coarse.faces) {
    Row<R> row;
    add_centre(row, corners, R(1));
    s.push_row(std::move(row));
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const bool boundary = mesh.boundary_edge(e);
    Row<R> row;
    for (const Index v : mesh.edges()[static_cast<std::size_t>(e)])
      row.push_back({v, quotient<R>(1, boundary ? 2 : 4)});
    if (!boundary)
      for (const Index f : mesh.edge_faces(e)) add_centre(row, face(f), quotient<R>(1, 4));
    s.push_row(std::move(row));
  }
  MeshFaces fine{s.rows(), {}};
  const Index first_edge = coarse.vertices + static_cast<Index>(coarse.faces.size());
  for (std::size_t f = 0; f < coarse.faces.size(); ++f) {
    const auto& corners = coarse.faces[f];
    const std::size_t n = corners.size();
    for (std::size_t i = 0; i < n; ++i)
      fine.faces.push_back({corners[i], first_edge + mesh.edge(corners[i], corners[(i + 1) % n]),
                            coarse.vertices + static_cast<Index>(f),
                            first_edge + mesh.edge(corners[(i + n - 1) % n], corners[i])});
  }
  return {std::move(fine), std::move(s)};
}

template <class R>
MeshStep<R> loop(const MeshFaces& coarse, MeshRule rule) {
  const MeshNeighbours mesh(coarse);
  for (std::size_t f = 0; f < coarse.faces.size(); ++f)
    if (coarse.faces[f].size() != 3)
      throw InvalidField("face " + std::to_string(f) + " has " +
                         std::to_string(coarse.faces[f].size()) +
                         " vertices; Loop's scheme needs triangles");
  SparseRows<R> s(coarse.vertices);
  for (Index v = 0; v < coarse.vertices; ++v) {
    if (mesh.on_boundary(v)) {
      s.push_row(boundary_vertex<R>(mesh, v, rule.rim));
      continue;
    }
    const auto n = static_cast<Index>(mesh.vertex_edges(v).size());
    const R beta = loop_beta<R>(rule.scheme, n);
    Row<R> row{{v, R(1) - R(static_cast<int>(n)) * beta}};
    for (const Index e : mesh.vertex_edges(v)) row.push_back({mesh.other_end(e, v), beta});
    s.push_row(std::move(row));
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    const auto& ends = mesh.edges()[static_cast<std::size_t>(e)];
    const bool boundary = mesh.boundary_edge(e);
    Row<R> row;
    for (const Index v : ends) row.push_back({v, boundary ? quotient<R>(1, 2) : quotient<R>(3, 8)});
    if (!boundary)
      for (const Index f : mesh.edge_faces(e))
        for (const Index v : coarse.faces[static_cast<std::size_t>(f)])
          if (v != ends[0] && v != ends[1]) row.push_back({v, quotient<R>(1, 8)});
    s.push_row(std::move(row));
  }
  MeshFaces fine{s.rows(), {}};
  for (const auto& face : coarse.faces) {
    std::array<Index, 3> middle{};
    for (std::size_t i = 0; i < 3; ++i)
      middle[i] = coarse.vertices + mesh.edge(face[i], face[(i + 1) % 3]);
    for (std::size_t i = 0; i < 3; ++i)
      fine.faces.push_back({face[i], middle[i], middle[(i + 2) % 3]});
    fine.faces.push_back({middle[0], middle[1], middle[2]});
  }
  return {std::move(fine), std::move(s)};
}

// The fine vertex at each corner of each face: corners are counted through.
std::vector<Index> first_corners(const MeshFaces& coarse) {
  std::vector<Index> first;
  Index count = 0;
  for (const auto& face : coarse.faces) {
    first.push_back(count);
    count += static_cast<Index>(face.size());
  }
  return first;
}

template <class R>
MeshStep<R> doo_sabin(const MeshFaces& coarse) {
  const MeshNeighbours mesh(coarse);
  const std::vector<Index> first = first_corners(coarse);
  SparseRows<R> s(coarse.vertices);
  for (const auto& face : coarse.faces) {
    const auto n = static_cast<Index>(face.size());
    for (Index i = 0; i < n; ++i) {
      Row<R> row;
      for (Index j = 0; j < n; ++j)
        row.push_back({face[static_cast<std::size_t>(j)], doo_sabin_weight<R>(i - j, n)});
      s.push_row(std::move(row));
    }
  }
  MeshFaces fine{s.rows(), {}};
  const auto corner = [&](Index f, Index v) {
    const auto& face = coarse.faces[static_cast<std::size_t>(f)];
    return first[static_cast<std::size_t>(f)] +
           (std::find(face.begin(), face.end(), v) - face.begin());
  };
  const auto follows = [&](Index f, Index a, Index b) {  // b behind a in face f
    const auto& face = coarse.faces[static_cast<std::size_t>(f)];
    const auto place =
        static_cast<std::size_t>(std::find(face.begin(), face.end(), a) - face.begin());
    return face[(place + 1) % face.size()] == b;
  };
  for (std::size_t f = 0; f < coarse.faces.size(); ++f) {
    std::vector<Index> inner;
    for (std::size_t i = 0; i < coarse.faces[f].size(); ++i)
      inner.push_back(first[f] + static_cast<Index>(i));
    fine.faces.push_back(std::move(inner));
  }
  for (Index e = 0; e < mesh.edge_count(); ++e) {
    if (mesh.boundary_edge(e)) continue;
    const auto [a, b] = mesh.edges()[static_cast<std::size_t>(e)];
    Index left = mesh.edge_faces(e)[0];
    Index right = mesh.edge_faces(e)[1];
    if (!follows(left, a, b)) std::swap(left, right);
    fine.faces.push_back({corner(left, b), corner(left, a), corner(right, a), corner(right, b)});
  }
  for (Index v = 0; v < coarse.vertices; ++v) {
    if (mesh.on_boundary(v)) continue;
    std::vector<Index> around;
    Index f = mesh.vertex_faces(v).front();
    for (std::size_t i = 0; i < mesh.vertex_faces(v).size(); ++i) {
      around.push_back(corner(f, v));
      // The next face around v lies behind the edge that comes into v.
      const auto& face = coarse.faces[static_cast<std::size_t>(f)];
      const auto place =
          static_cast<std::size_t>(std::find(face.begin(), face.end(), v) - face.begin());
      const auto& beside =
          mesh.edge_faces(mesh.edge(face[(place + face.size() - 1) % face.size()], v));
      f = beside[0] == f ? beside[1] : beside[0];
    }
    fine.faces.push_back(std::move(around));
  }
  return {std::move(fine), std::move(s)};
}

}  // namespace

template <class R>
MeshStep<R> mesh_step(const MeshFaces& coarse, MeshRule rule) {
  if (rule.triangles()) return loop<R>(coarse, rule);
  if (rule.scheme == MeshScheme::doo_sabin) return doo_sabin<R>(coarse);
  return catmull_clark<R>(coarse, rule.rim);
}

template MeshStep<double> mesh_step(const MeshFaces&, MeshRule);
template MeshStep<Rational> mesh_step(const MeshFaces&, MeshRule);

}  // namespace arete

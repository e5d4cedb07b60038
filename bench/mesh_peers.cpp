// SPDX-License-Identifier: MIT
// Catmull-Clark of a quad grid in space: GridSubdividerT beside its peers, each in a process of its
// own so that peak memory is its own too. Time is from the coarse mesh in the peer's own data
// structure to the fine mesh in it.
//
//     bench_mesh_peers [SIZE [LEVELS [LEVELS_OF_PEERS]]]        257 4 3
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/subdivision_method_3.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Subdivider/Uniform/CatmullClarkT.hh>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "arete/openmesh/grid_subdivider.h"
#include "arete/topology/grid_faces.h"

namespace {

using arete::Index;

struct Traits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

struct Case {
  Index rows;
  Index cols;
  int levels;
  [[nodiscard]] Index fine(Index n) const { return ((n - 1) << levels) + 1; }
  [[nodiscard]] double vertices() const {
    return static_cast<double>(fine(rows)) * static_cast<double>(fine(cols));
  }
};

OpenMesh::Vec3d place(Index r, Index c) {
  const auto x = static_cast<double>(c);
  const auto y = static_cast<double>(r);
  return {x, -y, 10 * std::sin(x / 9) * std::cos(y / 7) + std::sin(x * y)};
}

// Seconds of the part that counts; setting up is the caller's.
template <class F>
double seconds(F&& work) {
  // All peers use one thread: processor time is what they need, and other programs do not show.
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

PolyMesh poly_mesh(Index rows, Index cols) {
  PolyMesh mesh;
  const auto count = [](Index n) { return static_cast<std::size_t>(n); };
  mesh.reserve(count(rows * cols), count(2 * rows * cols), count(rows * cols));
  for (Index r = 0; r < rows; ++r)
    for (Index c = 0; c < cols; ++c) mesh.add_vertex(place(r, c));
  const arete::FaceList faces = arete::grid_faces({rows, cols}, true);
  for (int f = 0; f < faces.count(); ++f) {
    const auto q = faces[f];
    using V = PolyMesh::VertexHandle;
    mesh.add_face(V(q[0]), V(q[1]), V(q[2]), V(q[3]));
  }
  return mesh;
}

double arete_mesh(const Case& c) {
  PolyMesh mesh = poly_mesh(c.rows, c.cols);
  arete::openmesh::GridSubdividerT<PolyMesh> subdivide;
  return seconds([&] {
    if (!subdivide(mesh, static_cast<std::size_t>(c.levels))) std::abort();
  });
}

// What any OpenMesh result costs at least: a copy of the finished mesh, all of it in bulk.
double openmesh_copy(const Case& c) {
  PolyMesh mesh = poly_mesh(c.rows, c.cols);
  arete::openmesh::GridSubdividerT<PolyMesh> subdivide;
  subdivide(mesh, static_cast<std::size_t>(c.levels));
  PolyMesh copy;
  return seconds([&] { copy = mesh; });
}

// Connectivity and known points, nothing computed: the kernel's own calls, and the usual ones.
double openmesh_direct(const Case& c) {
  using namespace arete;
  PolyMesh mesh = poly_mesh(c.rows, c.cols);
  auto patches =
      recover_grids(openmesh::detail::mesh_faces(mesh), static_cast<int>(mesh.n_vertices()));
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const auto plan = openmesh::detail::plan_rebuild(
      std::move(patches), static_cast<int>(mesh.n_vertices()), {scheme, scheme, {}, c.levels});
  return seconds([&] {
    openmesh::detail::build_connectivity(mesh, plan);
    for (auto v : mesh.vertices()) mesh.set_point(v, {1, 2, static_cast<double>(v.idx())});
  });
}

double openmesh_add_face(const Case& c) {
  return seconds([&] { (void)poly_mesh(c.fine(c.rows), c.fine(c.cols)); });
}

double openmesh_catmull_clark(const Case& c) {
  PolyMesh mesh = poly_mesh(c.rows, c.cols);
  OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh> subdivide;
  return seconds([&] { subdivide(mesh, static_cast<std::size_t>(c.levels)); });
}

double cgal_catmull_clark(const Case& c) {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  for (Index r = 0; r < c.rows; ++r)
    for (Index k = 0; k < c.cols; ++k) {
      const auto p = place(r, k);
      mesh.add_vertex({p[0], p[1], p[2]});
    }
  const arete::FaceList faces = arete::grid_faces({c.rows, c.cols}, true);
  for (int f = 0; f < faces.count(); ++f) {
    const auto q = faces[f];
    using V = Mesh::Vertex_index;
    mesh.add_face(V(q[0]), V(q[1]), V(q[2]), V(q[3]));
  }
  return seconds([&] {
    CGAL::Subdivision_method_3::CatmullClark_subdivision(
        mesh, CGAL::parameters::number_of_iterations(static_cast<unsigned>(c.levels)));
  });
}

struct OsdPoint {
  double x = 0, y = 0, z = 0;
  void Clear() { x = y = z = 0; }
  void AddWithWeight(const OsdPoint& p, double w) {
    x += w * p.x;
    y += w * p.y;
    z += w * p.z;
  }
};

double opensubdiv_catmark(const Case& c) {
  namespace Far = OpenSubdiv::Far;
  namespace Sdc = OpenSubdiv::Sdc;
  const arete::FaceList faces = arete::grid_faces({c.rows, c.cols}, true);
  std::vector<OsdPoint> points;
  for (Index r = 0; r < c.rows; ++r)
    for (Index k = 0; k < c.cols; ++k) {
      const auto p = place(r, k);
      points.push_back({p[0], p[1], p[2]});
    }
  return seconds([&] {
    const std::vector<int> sizes(static_cast<std::size_t>(faces.count()), 4);
    Far::TopologyDescriptor descriptor;
    descriptor.numVertices = static_cast<int>(points.size());
    descriptor.numFaces = faces.count();
    descriptor.numVertsPerFace = sizes.data();
    descriptor.vertIndicesPerFace = faces.corners.data();
    Sdc::Options options;
    options.SetVtxBoundaryInterpolation(Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor, Factory::Options(Sdc::SCHEME_CATMARK, options)));
    refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(c.levels));
    const Far::PrimvarRefinerReal<double> interpolate(*refiner);
    for (int level = 1; level <= c.levels; ++level) {
      std::vector<OsdPoint> finer(
          static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
      interpolate.Interpolate(level, points, finer);
      points = std::move(finer);
    }
  });
}

struct Result {
  double time = 0;
  double peak = 0;  // bytes
};

Result in_own_process(double (*work)(const Case&), const Case& c) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    const double time = work(c);
    if (write(ends[1], &time, sizeof time) != sizeof time) _exit(1);
    _exit(0);
  }
  close(ends[1]);
  Result result;
  const bool read_all = read(ends[0], &result.time, sizeof result.time) == sizeof result.time;
  close(ends[0]);
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  if (!read_all) return {NAN, NAN};
  result.peak = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return result;
}

struct Peer {
  const char* name;
  double (*work)(const Case&);
  bool ours;
};

constexpr Peer peers[]{{"arete GridSubdividerT", arete_mesh, true},
                       {"copy of the result (OpenMesh)", openmesh_copy, true},
                       {"connectivity + points, kernel calls", openmesh_direct, true},
                       {"connectivity + points, add_face", openmesh_add_face, false},
                       {"OpenMesh CatmullClarkT", openmesh_catmull_clark, false},
                       {"CGAL CatmullClark_subdivision", cgal_catmull_clark, false},
                       {"OpenSubdiv Far (no mesh built)", opensubdiv_catmark, false}};

}  // namespace

int main(int argc, char** argv) {
  const Index size = argc > 1 ? std::atol(argv[1]) : 257;
  const int levels = argc > 2 ? std::atoi(argv[2]) : 4;
  const int peer_levels = argc > 3 ? std::atoi(argv[3]) : 3;
  std::printf(
      "| grid | levels | vertices | program | CPU s | ns / vertex | peak B / vertex | ratio |\n");
  std::printf("|---|---|---|---|---|---|---|---|\n");
  for (int level = 1; level <= levels; ++level) {
    const Case c{size, size, level};
    double reference = 0;
    for (const Peer& peer : peers) {
      if (!peer.ours && level > peer_levels) continue;
      Result best{1e300, 0};
      for (int run = 0; run < 3; ++run) {
        const Result result = in_own_process(peer.work, c);
        if (result.time < best.time) best = result;
      }
      if (peer.work == arete_mesh) reference = best.time;
      std::printf("| %ld x %ld | %d | %.3g M | %s | %.4f | %.1f | %.0f | %.2f |\n",
                  static_cast<long>(size), static_cast<long>(size), level, c.vertices() / 1e6,
                  peer.name, best.time, best.time / c.vertices() * 1e9, best.peak / c.vertices(),
                  best.time / reference);
      std::fflush(stdout);
    }
  }
  return 0;
}

// SPDX-License-Identifier: MIT
// Catmull-Clark of quad grids in space: GridSubdividerT beside its peers, each in a process of its
// own so that peak memory is its own too. Time is from the coarse mesh in the peer's own data
// structure to the fine mesh in it, and of all runs the best. Prints Markdown: bench/meshes.md.
//
//     bench_mesh_peers [LEVELS [LEVELS_OF_PEERS [RUNS]]]        4 4 3
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
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

#include "arete/gdal/band_source.h"
#include "arete/openmesh/grid_subdivider.h"
#include "arete/openmesh/internal/large_pages.h"
#include "arete/parallel/for_each_band.h"
#include "arete/topology/grid_faces.h"

namespace {

using arete::Index;

struct Traits : public OpenMesh::DefaultTraits {
  using Point = OpenMesh::Vec3d;
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;

// A grid whose vertex (r, c) lies at place(r, c).
struct Case {
  const arete::Grid<double>& heights;
  int levels;
  [[nodiscard]] Index rows() const { return heights.rows(); }
  [[nodiscard]] Index cols() const { return heights.cols(); }
  [[nodiscard]] OpenMesh::Vec3d place(Index r, Index c) const {
    return {30.0 * static_cast<double>(c), -30.0 * static_cast<double>(r), heights(r, c)};
  }
  [[nodiscard]] Index fine(Index n) const { return ((n - 1) << levels) + 1; }
  [[nodiscard]] double vertices() const {
    return static_cast<double>(fine(rows())) * static_cast<double>(fine(cols()));
  }
};

// Seconds of the part that counts; setting up is the caller's.
struct Seconds {
  double processor = 0;  ///< of all threads; other programs do not show in it
  double wall = 0;
};

template <class F>
Seconds seconds(F&& work) {
  const auto wall = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  return {static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC,
          std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count()};
}

std::size_t size_of(Index n) { return static_cast<std::size_t>(n); }

template <class Place>
PolyMesh poly_mesh(Index rows, Index cols, Place&& place) {
  PolyMesh mesh;
  mesh.reserve(size_of(rows * cols), size_of(2 * rows * cols), size_of(rows * cols));
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

PolyMesh coarse_mesh(const Case& c) {
  return poly_mesh(c.rows(), c.cols(), [&](Index r, Index k) { return c.place(r, k); });
}

Seconds arete_mesh(const Case& c) {
  PolyMesh mesh = coarse_mesh(c);
  arete::openmesh::GridSubdividerT<PolyMesh> subdivide;
  return seconds([&] {
    if (!subdivide(mesh, size_of(c.levels))) std::abort();
  });
}

// What any OpenMesh result of this size costs at least: its arrays filled once, in order, from
// nothing, in large pages.
Seconds floor_of_arrays(const Case& c) {
  PolyMesh mesh = coarse_mesh(c);
  const Index rows = c.fine(c.rows());
  const Index cols = c.fine(c.cols());
  return seconds([&] {
    const std::size_t edges = size_of(rows * (cols - 1) + (rows - 1) * cols);
    arete::openmesh::detail::reserve_in_large_pages(mesh, size_of(rows * cols), edges,
                                                    size_of((rows - 1) * (cols - 1)));
    mesh.resize(size_of(rows * cols), edges, size_of((rows - 1) * (cols - 1)));
    for (std::size_t e = 0; e < edges; ++e) {
      const auto h = static_cast<int>(2 * e);
      mesh.set_vertex_handle(PolyMesh::HalfedgeHandle(h), PolyMesh::VertexHandle(h));
    }
    for (auto v : mesh.vertices()) mesh.set_point(v, {1, 2, static_cast<double>(v.idx())});
  });
}

// A copy of the finished mesh.
Seconds openmesh_copy(const Case& c) {
  PolyMesh mesh = coarse_mesh(c);
  arete::openmesh::GridSubdividerT<PolyMesh> subdivide;
  subdivide(mesh, size_of(c.levels));
  PolyMesh copy;
  return seconds([&] { copy = mesh; });
}

// Known connectivity and known points by the setters of OpenMesh's kernel, nothing computed and
// nothing searched: the fastest way that OpenMesh offers. Of an open grid of quads, so that it is
// as simple as can be; the rim is left out.
Seconds openmesh_setters(const Case& c) {
  using H = PolyMesh::HalfedgeHandle;
  using V = PolyMesh::VertexHandle;
  using F = PolyMesh::FaceHandle;
  PolyMesh mesh;
  const int rows = static_cast<int>(c.fine(c.rows()));
  const int cols = static_cast<int>(c.fine(c.cols()));
  const auto along = [=](int r, int k) { return 2 * (r * (2 * cols - 1) + k); };
  const auto across = [=](int r, int k) { return 2 * (r * (2 * cols - 1) + cols - 1 + k); };
  return seconds([&] {
    mesh.resize(size_of(rows) * size_of(cols),
                size_of(rows) * size_of(cols - 1) + size_of(rows - 1) * size_of(cols),
                size_of(rows - 1) * size_of(cols - 1));
    for (int r = 0; r < rows; ++r) {
      for (int k = 0; k + 1 < cols; ++k) {
        const H east(along(r, k));
        const H west(along(r, k) + 1);
        mesh.set_vertex_handle(east, V(r * cols + k + 1));
        mesh.set_vertex_handle(west, V(r * cols + k));
        if (r + 1 < rows) {
          mesh.set_face_handle(east, F(r * (cols - 1) + k));
          mesh.set_next_halfedge_handle(east, H(across(r, k + 1)));
          mesh.set_halfedge_handle(F(r * (cols - 1) + k), east);
        }
        if (r > 0) {
          mesh.set_face_handle(west, F((r - 1) * (cols - 1) + k));
          mesh.set_next_halfedge_handle(west, H(across(r - 1, k) + 1));
        }
      }
      for (int k = 0; r + 1 < rows && k < cols; ++k) {
        const H north(across(r, k));
        const H south(across(r, k) + 1);
        mesh.set_vertex_handle(north, V((r + 1) * cols + k));
        mesh.set_vertex_handle(south, V(r * cols + k));
        if (k > 0) {
          mesh.set_face_handle(north, F(r * (cols - 1) + k - 1));
          mesh.set_next_halfedge_handle(north, H(along(r + 1, k - 1) + 1));
        }
        if (k + 1 < cols) {
          mesh.set_face_handle(south, F(r * (cols - 1) + k));
          mesh.set_next_halfedge_handle(south, H(along(r, k)));
        }
      }
      for (int k = 0; k < cols; ++k) {
        mesh.set_halfedge_handle(V(r * cols + k), H(k + 1 < cols ? along(r, k) : along(r, k - 1)));
        mesh.set_point(V(r * cols + k), {30.0 * k, -30.0 * r, 1});
      }
    }
  });
}

Seconds openmesh_add_face(const Case& c) {
  return seconds([&] {
    (void)poly_mesh(c.fine(c.rows()), c.fine(c.cols()), [](Index r, Index k) {
      return OpenMesh::Vec3d(30.0 * static_cast<double>(k), -30.0 * static_cast<double>(r), 1);
    });
  });
}

Seconds openmesh_catmull_clark(const Case& c) {
  PolyMesh mesh = coarse_mesh(c);
  OpenMesh::Subdivider::Uniform::CatmullClarkT<PolyMesh> subdivide;
  return seconds([&] { subdivide(mesh, size_of(c.levels)); });
}

Seconds cgal_catmull_clark(const Case& c) {
  using Mesh = CGAL::Surface_mesh<CGAL::Simple_cartesian<double>::Point_3>;
  Mesh mesh;
  for (Index r = 0; r < c.rows(); ++r)
    for (Index k = 0; k < c.cols(); ++k) {
      const auto p = c.place(r, k);
      mesh.add_vertex({p[0], p[1], p[2]});
    }
  const arete::FaceList faces = arete::grid_faces({c.rows(), c.cols()}, true);
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

Seconds opensubdiv_catmark(const Case& c) {
  namespace Far = OpenSubdiv::Far;
  namespace Sdc = OpenSubdiv::Sdc;
  const arete::FaceList faces = arete::grid_faces({c.rows(), c.cols()}, true);
  std::vector<OsdPoint> points;
  for (Index r = 0; r < c.rows(); ++r)
    for (Index k = 0; k < c.cols(); ++k) {
      const auto p = c.place(r, k);
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
  Seconds time{1e300, 1e300};
  double peak = 0;  // bytes
};

Result in_own_process(Seconds (*work)(const Case&), const Case& c) {
  int ends[2];
  if (pipe(ends) != 0) std::abort();
  const pid_t child = fork();
  if (child == 0) {
    const Seconds time = work(c);
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
  if (!read_all) result.time = {NAN, NAN};
  result.peak = 1024.0 * static_cast<double>(usage.ru_maxrss);
  return result;
}

struct Peer {
  const char* name;
  Seconds (*work)(const Case&);
  bool ours;
};

constexpr Peer peers[]{{"**arete GridSubdividerT**", arete_mesh, true},
                       {"floor: OpenMesh's arrays filled once", floor_of_arrays, true},
                       {"copy of the finished mesh", openmesh_copy, true},
                       {"connectivity and points, kernel setters", openmesh_setters, true},
                       {"connectivity and points, add_face", openmesh_add_face, false},
                       {"OpenMesh CatmullClarkT", openmesh_catmull_clark, false},
                       {"CGAL CatmullClark_subdivision", cgal_catmull_clark, false},
                       {"OpenSubdiv Far (no mesh built)", opensubdiv_catmark, false}};

std::string processor_name() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
    if (line.rfind("model name", 0) == 0) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

void print_heading(int argc, char** argv) {
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::localtime(&now));
  std::printf("%s, %d threads, %s, g++ %s, OpenMesh %d.%d, CGAL %s. `bench_mesh_peers", date,
              arete::available_threads(), processor_name().c_str(), __VERSION__,
              (OM_VERSION & 0xf0000) >> 16, (OM_VERSION & 0x0ff00) >> 8, CGAL_VERSION_STR);
  for (int i = 1; i < argc; ++i) std::printf(" %s", argv[i]);
  std::printf(
      "`\n\n| grid | levels | vertices | program | CPU s | wall s | ns / vertex | peak B / "
      "vertex | time / arete |\n|---|--:|--:|---|--:|--:|--:|--:|--:|\n");
}

}  // namespace

int main(int argc, char** argv) {
  const int levels = argc > 1 ? std::atoi(argv[1]) : 4;
  const int peer_levels = argc > 2 ? std::atoi(argv[2]) : 4;
  const int runs = argc > 3 ? std::atoi(argv[3]) : 3;
  arete::Grid<double> hills({257, 257});
  for (Index r = 0; r < 257; ++r)
    for (Index c = 0; c < 257; ++c)
      hills(r, c) =
          100 * std::sin(static_cast<double>(c) / 9) * std::cos(static_cast<double>(r) / 7);
  const arete::gdal::Raster raster(ARETE_SOURCE_DIR "/data/jacksboro_srtm3.tif");
  const auto dem = arete::gdal::read_band<double>(raster, raster.bands().front());

  print_heading(argc, argv);
  for (const auto* grid : std::initializer_list<const arete::Grid<double>*>{&hills, &dem}) {
    for (int level = 1; level <= levels; ++level) {
      const Case c{*grid, level};
      // Round by round, so that no program always meets the memory another has just given back; a
      // round that is thrown away comes first, because memory a machine has never touched is slow.
      std::vector<Result> best(std::size(peers));
      (void)in_own_process(floor_of_arrays, c);
      for (int run = 0; run < runs; ++run) {
        for (std::size_t i = 0; i < std::size(peers); ++i) {
          if (!peers[i].ours && level > peer_levels) continue;
          const Result result = in_own_process(peers[i].work, c);
          if (!(result.time.processor >= best[i].time.processor)) best[i] = result;
        }
      }
      for (std::size_t i = 0; i < std::size(peers); ++i) {
        if (!peers[i].ours && level > peer_levels) continue;
        // All use one thread; the first row is ours.
        const double time = best[i].time.processor;
        std::printf("| %ld x %ld | %d | %.3g M | %s | %.3f | %.3f | %.0f | %.0f | %.2f |\n",
                    static_cast<long>(c.rows()), static_cast<long>(c.cols()), level,
                    c.vertices() / 1e6, peers[i].name, time, best[i].time.wall,
                    time / c.vertices() * 1e9, best[i].peak / c.vertices(),
                    time / best[0].time.processor);
        std::fflush(stdout);
      }
    }
  }
  return 0;
}

// SPDX-License-Identifier: MIT
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/stencilTableFactory.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>
#include <opensubdiv/osd/cpuEvaluator.h>

#include <memory>

#include "arete/topology/grid_faces.h"
#include "peer.h"

namespace arete::bench {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Osd = OpenSubdiv::Osd;

struct Point {
  float x = 0, y = 0, z = 0;
  void Clear(void* = nullptr) { x = y = z = 0; }
  void AddWithWeight(const Point& p, float w) {
    x += w * p.x;
    y += w * p.y;
    z += w * p.z;
  }
};

std::vector<Point> control_points(const Job& job) {
  std::vector<Point> points;
  for (Index r = 0; r < job.heights.rows(); ++r)
    for (Index c = 0; c < job.heights.cols(); ++c)
      points.push_back({static_cast<float>(c), static_cast<float>(r), job.heights(r, c)});
  return points;
}

using Refiner = std::unique_ptr<Far::TopologyRefiner>;

Refiner refined_topology(const Job& job, const FaceList& faces) {
  const std::vector<int> sizes(static_cast<std::size_t>(faces.count()), 4);
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(job.heights.samples().size());
  descriptor.numFaces = faces.count();
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = faces.corners.data();
  OpenSubdiv::Sdc::Options options;
  options.SetVtxBoundaryInterpolation(OpenSubdiv::Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  Refiner refiner(
      Factory::Create(descriptor, Factory::Options(OpenSubdiv::Sdc::SCHEME_CATMARK, options)));
  refiner->RefineUniform(Far::TopologyRefiner::UniformOptions(job.levels));
  return refiner;
}

std::vector<Point> interpolated(const Far::TopologyRefiner& refiner, std::vector<Point> points) {
  const Far::PrimvarRefiner interpolate(refiner);
  for (int level = 1; level <= refiner.GetMaxLevel(); ++level) {
    std::vector<Point> finer(static_cast<std::size_t>(refiner.GetLevel(level).GetNumVertices()));
    interpolate.Interpolate(level, points, finer);
    points = std::move(finer);
  }
  return points;
}

std::vector<Vertex> to_vertices(const std::vector<Point>& points) {
  std::vector<Vertex> vertices;
  for (const Point& p : points) vertices.push_back({p.x, p.y, p.z});
  return vertices;
}

Run whole_call(const Job& job) {
  auto faces = std::make_shared<FaceList>(grid_faces(job.heights.extent(), true));
  auto result = std::make_shared<std::vector<Point>>();
  return {[=, &job] {
            const Refiner refiner = refined_topology(job, *faces);
            *result = interpolated(*refiner, control_points(job));
          },
          [=] { return to_vertices(*result); }};
}

Run ready_topology(const Job& job) {
  auto faces = std::make_shared<FaceList>(grid_faces(job.heights.extent(), true));
  std::shared_ptr<Far::TopologyRefiner> refiner(refined_topology(job, *faces));
  auto result = std::make_shared<std::vector<Point>>();
  auto points = std::make_shared<std::vector<Point>>(control_points(job));
  return {[=] { *result = interpolated(*refiner, *points); }, [=] { return to_vertices(*result); }};
}

Run ready_stencils(const Job& job) {
  const FaceList faces = grid_faces(job.heights.extent(), true);
  const Refiner refiner = refined_topology(job, faces);
  Far::StencilTableFactory::Options options;
  options.generateIntermediateLevels = false;
  options.generateOffsets = true;
  std::shared_ptr<const Far::StencilTable> table(
      Far::StencilTableFactory::Create(*refiner, options));
  auto points = std::make_shared<std::vector<Point>>(control_points(job));
  auto result =
      std::make_shared<std::vector<Point>>(static_cast<std::size_t>(table->GetNumStencils()));
  return {[=] {
            const Osd::BufferDescriptor three(0, 3, 3);
            Osd::CpuEvaluator::EvalStencils(&(*points)[0].x, three, &(*result)[0].x, three,
                                            table->GetSizes().data(), table->GetOffsets().data(),
                                            table->GetControlIndices().data(),
                                            table->GetWeights().data(), 0, table->GetNumStencils());
          },
          [=] { return to_vertices(*result); }};
}

}  // namespace

std::vector<Peer> opensubdiv_peers() {
  return {{"OpenSubdiv, refine and PrimvarRefiner", true, true, 120, 3, whole_call},
          {"OpenSubdiv, PrimvarRefiner on a ready refiner", true, false, 30, 3, ready_topology},
          {"OpenSubdiv, CpuEvaluator on ready stencils", true, false, 30, 3, ready_stencils}};
}

}  // namespace arete::bench

// SPDX-License-Identifier: MIT
#include "arete/opensubdiv/subdivide_mesh.h"

#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <array>
#include <memory>

namespace arete::opensubdiv {
namespace {

namespace Far = OpenSubdiv::Far;
namespace Sdc = OpenSubdiv::Sdc;

struct Point {
  std::array<double, 3> x{};
  void Clear() { x = {}; }
  void AddWithWeight(const Point& other, double weight) {
    for (std::size_t k = 0; k < 3; ++k) x[k] += weight * other.x[k];
  }
};

}  // namespace

Mesh subdivide(const Mesh& mesh, MeshRule rule, int levels) {
  if (rule.scheme == MeshScheme::loop_warren || rule.scheme == MeshScheme::doo_sabin ||
      rule.rim == MeshRim::thirds)
    throw InvalidField("OpenSubdiv has no such rule");
  std::vector<int> sizes;
  std::vector<int> corners;
  for (const auto& face : mesh.faces.faces) {
    sizes.push_back(static_cast<int>(face.size()));
    for (const Index v : face) corners.push_back(static_cast<int>(v));
  }
  Far::TopologyDescriptor descriptor;
  descriptor.numVertices = static_cast<int>(mesh.faces.vertices);
  descriptor.numFaces = static_cast<int>(sizes.size());
  descriptor.numVertsPerFace = sizes.data();
  descriptor.vertIndicesPerFace = corners.data();
  Sdc::Options options;
  options.SetVtxBoundaryInterpolation(rule.rim == MeshRim::sharp_corners
                                          ? Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER
                                          : Sdc::Options::VTX_BOUNDARY_EDGE_ONLY);
  using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
  const std::unique_ptr<Far::TopologyRefiner> refiner(Factory::Create(
      descriptor,
      Factory::Options(rule.triangles() ? Sdc::SCHEME_LOOP : Sdc::SCHEME_CATMARK, options)));
  if (!refiner) throw InvalidField("OpenSubdiv refused the mesh");
  if (levels > 0) {
    Far::TopologyRefiner::UniformOptions uniform(levels);
    uniform.fullTopologyInLastLevel = true;
    refiner->RefineUniform(uniform);
  }
  const Far::PrimvarRefinerReal<double> interpolate(*refiner);
  std::vector<Point> points(static_cast<std::size_t>(mesh.positions.rows()));
  for (std::size_t v = 0; v < points.size(); ++v)
    std::copy_n(mesh.positions.row(static_cast<Index>(v)), 3, points[v].x.begin());
  for (int level = 1; level <= levels; ++level) {
    std::vector<Point> finer(static_cast<std::size_t>(refiner->GetLevel(level).GetNumVertices()));
    interpolate.Interpolate(level, points, finer);
    points = std::move(finer);
  }
  const Far::TopologyLevel& last = refiner->GetLevel(levels);
  Mesh result{{last.GetNumVertices(), {}}, Grid<double>({last.GetNumVertices(), 3})};
  for (int f = 0; f < last.GetNumFaces(); ++f) {
    const Far::ConstIndexArray face = last.GetFaceVertices(f);
    result.faces.faces.emplace_back(face.begin(), face.end());
  }
  for (std::size_t v = 0; v < points.size(); ++v)
    std::copy_n(points[v].x.begin(), 3, result.positions.row(static_cast<Index>(v)));
  return result;
}

}  // namespace arete::opensubdiv

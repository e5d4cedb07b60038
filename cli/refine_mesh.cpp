// SPDX-License-Identifier: MIT
#include "cli/refine_mesh.h"

#include <chrono>
#include <iomanip>
#include <iostream>
#include <sstream>

#include "arete/parallel/for_each_band.h"
#include "arete/refine/refiner.h"
#include "cli/error.h"
#include "cli/memory_size.h"
#include "cli/output_file.h"
#include "cli/progress.h"
#include "cli/scheme_json.h"
#ifdef ARETE_HAVE_VTK
#include "arete/vtk/write_mesh.h"
#endif

namespace arete::cli {
namespace {

using openmesh::MeshData;
using openmesh::RefinedMeshSize;

bool is_vtp(const std::string& path) { return std::filesystem::path(path).extension() == ".vtp"; }

void check_form(const std::string& output) {
  if (openmesh::is_mesh_file(output)) return;
  if (!is_vtp(output))
    throw Misuse(output +
                 ": a mesh is refined into a .obj, .ply, .off, .stl or .vtp; name the output so");
#ifndef ARETE_HAVE_VTK
  throw Failure(output + ": this arete was built without VTK; write a .ply");
#endif
}

void write(const MeshJob& job, const MeshData& mesh, const std::filesystem::path& path,
           ProgressBar& progress) {
#ifdef ARETE_HAVE_VTK
  if (is_vtp(job.output)) {
    vtk::PolygonMesh polygons{mesh.points, mesh.faces, mesh.normals, mesh.colors, mesh.texcoords};
    polygons.notes = {{"arete_scheme", job.x.text()},
                      {"arete_scheme_y", job.y.text()},
                      {"arete_levels", std::to_string(job.options.levels)}};
    vtk::write_mesh(polygons, path);
    return;
  }
#endif
  openmesh::MeshOutput output;
  output.single_precision = job.single_precision;
  output.progress = [&](double share) { progress.show(0.5 + share / 2); };
  openmesh::write_mesh(path.string(), mesh, output);
}

// What the output's format has no place for.
std::string lost_attributes(const MeshJob& job, const MeshData& mesh) {
  const std::string form = std::filesystem::path(job.output).extension().string();
  const bool stl = form == ".stl" || form == ".STL";
  if (stl && !(mesh.colors.empty() && mesh.texcoords.empty() && mesh.corner_texcoords.empty()))
    return "an .stl has no colours or texture coordinates; they are left out";
  const bool by_corner = form != ".off" && form != ".OFF" && form != ".vtp";
  if (!by_corner && !mesh.corner_texcoords.empty())
    return "texture coordinates with seams have no place in a " + form +
           " and are left out; write an .obj or .ply";
  return "";
}

std::string extent_text(Extent extent) {
  return std::to_string(extent.cols) + " x " + std::to_string(extent.rows);
}

void report(const MeshJob& job, const RefinedMeshSize& size, const std::string& lost,
            double seconds) {
  const int threads = job.options.threads > 0 ? job.options.threads : available_threads();
  const double speed = seconds > 0 ? size.vertices / seconds : 0;
  const bool one = size.patches.size() == 1;
  if (job.json) {
    Json object{{"input", job.input}, {"output", job.output}};
    object["rows"] = one ? Json(size.patches.front().fine.rows) : Json(nullptr);
    object["cols"] = one ? Json(size.patches.front().fine.cols) : Json(nullptr);
    object["vertices"] = static_cast<std::int64_t>(size.vertices);
    object["faces"] = static_cast<std::int64_t>(size.faces);
    object["grids"] = Json::array();
    for (const auto& patch : size.patches)
      object["grids"].push_back({{"input_rows", patch.coarse.rows},
                                 {"input_cols", patch.coarse.cols},
                                 {"rows", patch.fine.rows},
                                 {"cols", patch.fine.cols}});
    object["levels"] = job.options.levels;
    object["scheme"] = job.x.text();
    if (!(job.x == job.y)) object["scheme_y"] = job.y.text();
    object["seconds"] = seconds;
    object["samples_per_second"] = speed;
    object["threads"] = threads;
    std::cout << object.dump(2) << '\n';
    return;
  }
  std::ostringstream line;
  line << job.input << " -> " << job.output << " (";
  if (one)
    line << "grid of " << extent_text(size.patches.front().coarse) << " -> "
         << extent_text(size.patches.front().fine);
  else
    line << size.patches.size() << " grids, " << std::fixed << std::setprecision(0) << size.vertices
         << " vertices";
  line << "): " << job.x.text() << (job.x == job.y ? "" : " along x, " + job.y.text() + " along y")
       << ", " << job.options.levels << (job.options.levels == 1 ? " level" : " levels")
       << std::fixed << std::setprecision(2) << ", " << seconds << " s, " << std::setprecision(1)
       << speed / 1e6 << " M vertices/s";
  std::cout << line.str() << '\n';
  if (!lost.empty()) std::cout << "note: " << lost << '\n';
}

}  // namespace

void refine_mesh_file(const MeshJob& job) {
  check_form(job.output);
  OutputFile output(job.output, job.input, job.overwrite);
  const auto start = std::chrono::steady_clock::now();
  ProgressBar progress("refining");
  MeshData mesh = openmesh::read_mesh(job.input);
  // OBJ has only those of corners; without seams they are those of vertices, and far fewer.
  if (!mesh.corner_texcoords.empty() && mesh.texcoords.empty() && openmesh::is_seamless(mesh)) {
    mesh.texcoords = openmesh::vertex_texcoords(mesh);
    mesh.corner_texcoords.clear();
  }
  progress.show(0.1);
  openmesh::MeshRefineOptions options = job.options;
  options.normals = options.normals || is_vtp(job.output);
  RefinedMeshSize size;
  try {
    size = openmesh::refined_size(mesh, job.x, job.y, options);
    check_memory("a mesh of " + std::to_string(static_cast<long long>(size.vertices)) + " vertices",
                 size.bytes, job.max_memory);
    mesh = openmesh::refine_mesh(mesh, job.x, job.y, options);
  } catch (const InvalidField& error) {
    throw Failure(job.input + ": " + error.what());
  }
  progress.show(0.5);
  write(job, mesh, output.temporary(), progress);
  const std::string lost = lost_attributes(job, mesh);
  progress.show(1);
  output.commit();
  report(job, size, lost,
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

}  // namespace arete::cli

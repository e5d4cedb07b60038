// SPDX-License-Identifier: MIT
#include "cli/coarsen_mesh.h"

#include <chrono>
#include <iostream>

#include "arete/openmesh/reverse_mesh.h"
#include "arete/scheme/catalogue.h"
#include "cli/details_store.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/scheme_json.h"

namespace arete::cli {
namespace {

void set_grid_scheme(const CoarsenMeshArguments& a, openmesh::MeshCoarsenOptions& options) {
  try {
    options.grid_scheme = parse_scheme(a.scheme);
  } catch (const InvalidScheme& error) {
    throw Misuse("--scheme " + a.scheme +
                 ": any mesh is coarsened by catmull-clark, loop, loop-warren or doo-sabin, and "
                 "a grid by schemes of the catalogue: " +
                 error.what());
  }
  if (!a.boundary.empty()) options.boundaries = parse_boundaries(a.boundary);
  if (!a.rim.empty())
    throw Misuse("--rim is for catmull-clark, loop and loop-warren; " + a.scheme +
                 " on a grid has --boundary");
}

openmesh::MeshCoarsenOptions options_from(const CoarsenMeshArguments& a) {
  openmesh::MeshCoarsenOptions options;
  if (const auto scheme = parse_mesh_scheme(a.scheme)) {
    options.scheme = *scheme;
    if (!a.boundary.empty())
      throw Misuse("--boundary is for grids and schemes of the catalogue; " + a.scheme +
                   " has --rim");
  } else {
    set_grid_scheme(a, options);
  }
  if (!a.rim.empty()) {
    options.rim = parse_mesh_rim(a.rim);
    if (!options.rim) throw Misuse("--rim " + a.rim + ": choose smooth, sharp-corners or thirds");
  }
  options.mode = parse_reverse_mode(a.mode);
  options.levels = a.levels;
  options.threshold = a.threshold;
  options.target_rmse = a.target_rmse;
  return options;
}

void check_form(const std::string& path) {
  if (!openmesh::is_mesh_file(path))
    throw Misuse(path + ": a mesh is an .obj, .ply, .off or .stl; name the output so");
}

std::string form_of(const std::string& path) {
  return std::filesystem::path(path).extension().string().substr(1);
}

// Details fit what will be read back: a format that rounds or drops something is no place for it.
void check_kept(const std::string& path, const std::filesystem::path& written,
                const openmesh::MeshData& mesh) {
  const openmesh::MeshData again = openmesh::read_mesh(written.string());
  const char* lost = nullptr;
  if (again.points != mesh.points || again.faces.corners != mesh.faces.corners)
    lost = "vertices as they are";
  else if (again.colors != mesh.colors)
    lost = "colours";
  else if (again.normals != mesh.normals)
    lost = "normals";
  else if (again.texcoords != mesh.texcoords || again.corner_texcoords != mesh.corner_texcoords)
    lost = "these texture coordinates";
  if (lost)
    throw Failure(path + " cannot hold " + lost + ", and the details would not fit; use .ply");
}

// What was done at the rim, by its name: "rim", or for grids "boundary" (x, then y).
std::pair<std::string, std::string> edge_of(const MeshDetailsFile& details) {
  if (!details.grid) return {"rim", std::string(to_string(details.rule.rim))};
  const Boundaries& b = details.grid->boundaries;
  return {"boundary", std::string(to_string(b.x)) + "," + std::string(to_string(b.y))};
}

void report(const CoarsenMeshArguments& a, const openmesh::MeshData& input,
            const openmesh::CoarsenedMesh& done, std::size_t bytes, double seconds) {
  const std::string scheme = done.details.scheme_text();
  const auto [edge, kind] = edge_of(done.details);
  if (a.json) {
    Json object{{"input", a.input},
                {"output", a.output},
                {"vertices", input.points.size()},
                {"faces", input.faces.count()},
                {"coarse_vertices", done.coarse.points.size()},
                {"coarse_faces", done.coarse.faces.count()},
                {"levels", a.levels},
                {"scheme", scheme},
                {edge, kind},
                {"mode", a.mode},
                {"unique", done.unique},
                {"largest_detail", done.largest_detail},
                {"seconds", seconds}};
    if (!a.details.empty()) {
      object["details"] = a.details;
      object["details_bytes"] = bytes;
      object["details_all"] = done.count.all;
      object["details_kept"] = done.count.kept;
      object["threshold"] = done.threshold;
      object["rmse"] = done.error.rmse;
      object["max_error"] = done.error.largest;
    }
    std::cout << object.dump(2) << '\n';
    return;
  }
  std::cout << a.input << " (" << input.points.size() << " vertices) -> " << a.output << " ("
            << done.coarse.points.size() << " vertices): " << scheme << ", " << edge << " " << kind
            << ", " << a.mode << ", " << a.levels << (a.levels == 1 ? " level" : " levels")
            << "; the largest detail is " << done.largest_detail << '\n';
  if (!a.details.empty())
    std::cout << a.details << ": " << done.count.kept << " of " << done.count.all
              << " details kept, " << bytes << " bytes; restored, the RMSE is " << done.error.rmse
              << " and the largest error " << done.error.largest << '\n';
  if (!done.unique)
    std::cout << "note: Catmull-Clark does not determine this control mesh: a closed part has "
                 "valence 3 everywhere and no odd cycle of edges (as a cube), so that moving its "
                 "vertices by +t and -t in turn changes no fine vertex; the one of least norm is "
                 "written\n";
}

}  // namespace

void coarsen_mesh(const CoarsenMeshArguments& a) {
  const auto start = std::chrono::steady_clock::now();
  check_form(a.output);
  const openmesh::MeshCoarsenOptions options = options_from(a);
  const openmesh::MeshData input = openmesh::read_mesh(a.input);
  OutputFile output(a.output, a.input, a.overwrite);
  std::optional<OutputFile> details_output;
  if (!a.details.empty()) details_output.emplace(a.details, a.input, a.overwrite);
  openmesh::CoarsenedMesh done;
  try {
    done = openmesh::coarsen_mesh(input, options);
  } catch (const InvalidField& error) {
    throw Failure(a.input + ": " + error.what());
  }
  stop_if_interrupted();
  openmesh::write_mesh(output.temporary().string(), done.coarse, {form_of(a.output)});
  std::size_t bytes = 0;
  if (details_output) {
    check_kept(a.output, output.temporary(), done.coarse);
    bytes = write_details(details_output->temporary(), done.details);
  }
  stop_if_interrupted();
  if (details_output) details_output->commit();
  output.commit();
  report(a, input, done, bytes,
         std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
}

void restore_mesh(const RestoreMeshArguments& a) {
  check_form(a.output);
  const MeshDetailsFile details = read_mesh_details(a.details);
  const int all = static_cast<int>(details.levels.size());
  const int levels = a.levels.value_or(all);
  if (levels < 0 || levels > all)
    throw Misuse("--levels " + std::to_string(levels) + ": " + a.details + " holds " +
                 std::to_string(all) + "; give 0 to " + std::to_string(all));
  const openmesh::MeshData coarse = openmesh::read_mesh(a.coarse);
  OutputFile output(a.output, a.coarse, a.overwrite);
  openmesh::MeshData mesh;
  try {
    mesh = openmesh::restore_mesh(coarse, details, levels, a.edited);
  } catch (const InvalidDetails& error) {
    throw Failure(a.coarse + " with " + a.details + ": " + error.what());
  }
  openmesh::write_mesh(output.temporary().string(), mesh, {form_of(a.output)});
  stop_if_interrupted();
  output.commit();
  const auto [edge, kind] = edge_of(details);
  if (a.json)
    std::cout << Json{{"input", a.coarse},
                      {"details", a.details},
                      {"output", a.output},
                      {"vertices", mesh.points.size()},
                      {"faces", mesh.faces.count()},
                      {"levels", levels},
                      {"of_levels", all},
                      {"scheme", details.scheme_text()},
                      {edge, kind},
                      {"mode", std::string(to_string(details.mode))},
                      {"lossy", details.lossy}}
                     .dump(2)
              << '\n';
  else
    std::cout << a.coarse << " + " << a.details << " -> " << a.output << " (" << mesh.points.size()
              << " vertices): " << levels << " of " << all << " levels restored"
              << (details.lossy ? " from thinned details" : "") << '\n';
}

}  // namespace arete::cli

// SPDX-License-Identifier: MIT
#include "cli/surface_file.h"

#include <charconv>
#include <cmath>
#include <fstream>

#include "cli/error.h"
#include "cli/point_stream.h"
#ifdef ARETE_HAVE_VTK
#include "cli/surface_picture.h"
#endif
#include "arete/variational/cotangent.h"

namespace arete::cli {
namespace {

// Numbers as the shortest texts that read back as themselves, blanks between them.
class NumberText {
 public:
  explicit NumberText(std::ofstream& stream) : stream_(stream) {}
  void operator()(const Point3& point) const {
    for (const double x : point) (*this)(x);
    stream_ << '\n';
  }
  void operator()(double value) const {
    char text[64];
    stream_ << ' ';
    stream_.write(text, std::to_chars(text, text + sizeof text, value).ptr - text);
  }

 private:
  std::ofstream& stream_;
};

void write_obj(const SurfaceMesh& mesh, std::ofstream& stream) {
  const NumberText number(stream);
  stream << "# written by arete\n";
  for (const Point3& p : mesh.points) {
    stream << 'v';
    number(p);
  }
  for (const Point3& n : unit_normals(mesh)) {
    stream << "vn";
    number(n);
  }
  for (const auto& triangle : mesh.triangles) {
    stream << 'f';
    for (const int i : triangle) stream << ' ' << i + 1 << "//" << i + 1;
    stream << '\n';
  }
}

// VTK's XML in its plain-text form, which every version reads.
void write_vtp(const SurfaceMesh& mesh, std::ofstream& stream) {
  const NumberText number(stream);
  const auto array = [&stream](const char* type, const char* name, int components, auto&& body) {
    stream << "<DataArray type=\"" << type << "\" Name=\"" << name << "\" NumberOfComponents=\""
           << components << "\" format=\"ascii\">\n";
    body();
    stream << "\n</DataArray>\n";
  };
  stream << "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"1.0\" "
            "byte_order=\"LittleEndian\">\n<PolyData>\n<Piece NumberOfPoints=\""
         << mesh.points.size() << "\" NumberOfPolys=\"" << mesh.triangles.size()
         << "\">\n<PointData Normals=\"Normals\" Scalars=\"mean_curvature\">\n";
  array("Float64", "Normals", 3, [&] {
    for (const Point3& n : unit_normals(mesh)) number(n);
  });
  array("Float64", "mean_curvature", 1, [&] {
    for (const double h : mean_curvatures(mesh)) number(h);
  });
  stream << "</PointData>\n<Points>\n";
  array("Float64", "Points", 3, [&] {
    for (const Point3& p : mesh.points) number(p);
  });
  stream << "</Points>\n<Polys>\n";
  array("Int64", "connectivity", 1, [&] {
    for (const auto& [a, b, c] : mesh.triangles) stream << a << ' ' << b << ' ' << c << '\n';
  });
  array("Int64", "offsets", 1, [&] {
    for (std::size_t t = 1; t <= mesh.triangles.size(); ++t) stream << 3 * t << '\n';
  });
  stream << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
}

}  // namespace

void check_surface_form(const std::string& output) {
  const std::string form = std::filesystem::path(output).extension().string();
  if (form != ".vtp" && form != ".obj" && form != ".csv" && form != ".png")
    throw Misuse(output + ": the format '" + form +
                 "' is not one of .vtp, .obj, .csv, .png; name the output so");
#ifndef ARETE_HAVE_VTK
  if (form == ".png") throw Failure(output + ": this arete was built without VTK; write a .vtp");
#endif
}

void write_surface(const MinimalSurface& surface, const SurfaceView& view,
                   const std::filesystem::path& path) {
  const std::string form = path.extension().string();
#ifdef ARETE_HAVE_VTK
  if (form == ".png") {
    draw_surface(surface, view, path);
    return;
  }
#else
  (void)view;
#endif
  if (form == ".csv") {
    PointStream stream(path, {"x", "y", "z"});
    for (const Point3& p : surface.mesh.points) stream.write({p[0], p[1], p[2]});
    stream.close();
    return;
  }
  std::ofstream stream(path, std::ios::binary);
  if (form == ".obj")
    write_obj(surface.mesh, stream);
  else
    write_vtp(surface.mesh, stream);
  stream.close();
  if (!stream) throw Failure(path.string() + " cannot be written; check free space");
}

}  // namespace arete::cli

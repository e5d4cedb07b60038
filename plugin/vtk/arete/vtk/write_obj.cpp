// SPDX-License-Identifier: MIT
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>

#include <charconv>

#include "arete/vtk/internal/model.h"

namespace arete::vtk {
namespace {

/// Lines of numbers, written in large pieces. Floats are written with as few digits as give them
/// back exactly.
class ObjText {
 public:
  explicit ObjText(ModelFile& file) : file_(file) { text_.reserve(full + 4096); }

  ObjText& operator<<(const std::string& words) {
    text_ += words;
    if (text_.size() > full) flush();
    return *this;
  }
  ObjText& operator<<(const char* words) { return *this << std::string(words); }
  template <class Number>
  void number(Number value) {
    std::array<char, 32> digits;
    const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
    text_.append(digits.data(), end);
  }
  void array(const char* key, vtkDataArray& values) {
    for (Index k = 0; k < values.GetNumberOfTuples(); ++k) {
      text_ += key;
      for (int c = 0; c < values.GetNumberOfComponents(); ++c) {
        text_ += ' ';
        number(static_cast<float>(values.GetComponent(k, c)));
      }
      *this << "\n";
    }
  }
  void flush() {
    file_.write(text_.data(), text_.size());
    text_.clear();
  }

 private:
  static constexpr std::size_t full = 1 << 20;
  ModelFile& file_;
  std::string text_;
};

/// A comment, on one line whatever the text.
std::string one_line(std::string text) {
  for (char& c : text)
    if (c == '\n' || c == '\r') c = ' ';
  return text;
}

void write_mesh(const Surface& surface, const ModelOptions& options, const Model& model,
                const ObjFiles& files) {
  ModelFile file(files.obj);
  ObjText out(file);
  out << "# arete: a terrain in its own plane, z up; exaggerated ";
  out.number(options.exaggeration);
  out << " times\n# origin";
  for (const double value : model.report.origin) {
    out << " ";
    out.number(value);
  }
  out << "\n";
  if (!surface.crs_wkt.empty()) out << "# crs " + one_line(surface.crs_wkt) + "\n";
  for (const Note& note : surface.notes) out << "# " + one_line(note.name + " " + note.text) + "\n";
  out << "mtllib " + files.mtl_name + "\no " + one_line(options.name) + "\n";
  vtkPolyData& mesh = *model.mesh.data;
  out.array("v", *mesh.GetPoints()->GetData());
  out.array("vt", *mesh.GetPointData()->GetTCoords());
  out.array("vn", *mesh.GetPointData()->GetNormals());
  out << "usemtl ground\ns 1\n";
  vtkCellArray& quads = *mesh.GetPolys();
  for (vtkIdType quad = 0; quad < quads.GetNumberOfCells(); ++quad) {
    vtkIdType count = 0;
    const vtkIdType* corners = nullptr;
    quads.GetCellAtId(quad, count, corners);
    out << "f";
    for (vtkIdType k = 0; k < count; ++k) {
      for (const char* before : {" ", "/", "/"}) {
        out << before;
        out.number(corners[k] + 1);
      }
    }
    out << "\n";
  }
  out.flush();
  file.close();
}

void write_material(const ObjFiles& files) {
  const std::string text =
      "# arete\nnewmtl ground\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nd 1\nillum 1\nmap_Kd " +
      files.texture_name + "\n";
  ModelFile file(files.mtl);
  file.write(text.data(), text.size());
  file.close();
}

}  // namespace

ModelReport write_obj(const Surface& surface, const ModelOptions& options, const ObjFiles& files) {
  const Model model = make_model(surface, options);
  write_mesh(surface, options, model, files);
  write_material(files);
  write_png(model.texture, files.texture);
  return model.report;
}

}  // namespace arete::vtk

// SPDX-License-Identifier: MIT
// Binary glTF 2.0, https://registry.khronos.org/glTF/specs/2.0/glTF-2.0.html: VTK 9.1's own
// vtkGLTFExporter writes the JSON form only, with everything as base64 text.
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtk_jsoncpp.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/model.h"

namespace arete::vtk {
namespace {

static_assert(sizeof(float) == 4, "glTF has 32-bit floats");

using Bytes = std::vector<std::uint8_t>;

enum Constant { float_type = 5126, uint_type = 5125, vertices = 34962, indices = 34963 };

/// The JSON and the binary part, growing together.
class Document {
 public:
  Json::Value json;

  /// \returns the index of the new view.
  int add_view(const void* data, std::size_t size, int target) {
    while (binary.size() % 4 != 0) binary.push_back(0);
    Json::Value view;
    view["buffer"] = 0;
    view["byteOffset"] = Json::UInt64(binary.size());
    view["byteLength"] = Json::UInt64(size);
    if (target != 0) view["target"] = target;
    const auto* bytes = static_cast<const std::uint8_t*>(data);
    binary.insert(binary.end(), bytes, bytes + size);
    return append("bufferViews", view);
  }
  template <class T>
  Json::Value& add_accessor(const std::vector<T>& values, int components, const char* type,
                            int component_type, int target) {
    Json::Value accessor;
    accessor["bufferView"] = add_view(values.data(), values.size() * sizeof(T), target);
    accessor["componentType"] = component_type;
    accessor["count"] = Json::UInt64(values.size() / static_cast<std::size_t>(components));
    accessor["type"] = type;
    return json["accessors"][append("accessors", accessor)];
  }
  int append(const char* list, const Json::Value& entry) {
    json[list].append(entry);
    return static_cast<int>(json[list].size()) - 1;
  }

  Bytes binary;
};

/// glTF's y is up, and its z comes towards who looks north.
std::vector<float> turned(vtkDataArray& array) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(array.GetNumberOfTuples()) * 3);
  for (Index k = 0; k < array.GetNumberOfTuples(); ++k) {
    values.push_back(static_cast<float>(array.GetComponent(k, 0)));
    values.push_back(static_cast<float>(array.GetComponent(k, 2)));
    values.push_back(static_cast<float>(-array.GetComponent(k, 1)));
  }
  return values;
}

/// glTF's v runs down from a texture's first row.
std::vector<float> from_the_top(vtkDataArray& array) {
  std::vector<float> values;
  values.reserve(static_cast<std::size_t>(array.GetNumberOfTuples()) * 2);
  for (Index k = 0; k < array.GetNumberOfTuples(); ++k) {
    values.push_back(static_cast<float>(array.GetComponent(k, 0)));
    values.push_back(static_cast<float>(1 - array.GetComponent(k, 1)));
  }
  return values;
}

std::vector<std::uint32_t> triangles(vtkPolyData& mesh) {
  vtkCellArray& quads = *mesh.GetPolys();
  std::vector<std::uint32_t> result;
  result.reserve(static_cast<std::size_t>(quads.GetNumberOfCells()) * 6);
  const auto distance = [&](vtkIdType a, vtkIdType b) {
    Vector3 p, q;
    mesh.GetPoint(a, p.data());
    mesh.GetPoint(b, q.data());
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
  };
  for (vtkIdType quad = 0; quad < quads.GetNumberOfCells(); ++quad) {
    vtkIdType count = 0;
    const vtkIdType* c = nullptr;
    quads.GetCellAtId(quad, count, c);
    // Whichever diagonal, the corners keep turning the same way round.
    const int first = distance(c[0], c[2]) <= distance(c[1], c[3]) ? 0 : 1;
    for (const int k : {0, 1, 2, 0, 2, 3})
      result.push_back(static_cast<std::uint32_t>(c[(first + k) % 4]));
  }
  return result;
}

void add_bounds(const std::vector<float>& points, Json::Value& accessor) {
  for (std::size_t c = 0; c < 3; ++c) {
    float low = std::numeric_limits<float>::infinity();
    float high = -low;
    for (std::size_t k = c; k < points.size(); k += 3) {
      low = std::min(low, points[k]);
      high = std::max(high, points[k]);
    }
    accessor["min"].append(low);
    accessor["max"].append(high);
  }
}

void add_mesh(const ModelOptions& options, vtkPolyData& mesh, Document& document) {
  Json::Value primitive;
  const auto last = [&] { return static_cast<int>(document.json["accessors"].size()) - 1; };
  const auto points = turned(*mesh.GetPoints()->GetData());
  add_bounds(points, document.add_accessor(points, 3, "VEC3", float_type, vertices));
  primitive["attributes"]["POSITION"] = last();
  document.add_accessor(turned(*mesh.GetPointData()->GetNormals()), 3, "VEC3", float_type,
                        vertices);
  primitive["attributes"]["NORMAL"] = last();
  document.add_accessor(from_the_top(*mesh.GetPointData()->GetTCoords()), 2, "VEC2", float_type,
                        vertices);
  primitive["attributes"]["TEXCOORD_0"] = last();
  document.add_accessor(triangles(mesh), 1, "SCALAR", uint_type, indices);
  primitive["indices"] = last();
  primitive["material"] = 0;
  primitive["mode"] = 4;  // triangles
  Json::Value entry;
  entry["name"] = options.name;
  entry["primitives"].append(primitive);
  document.append("meshes", entry);
}

void add_material(const Image& texture, const std::filesystem::path& path, Document& document) {
  const Bytes png = encode_png(texture, path);
  Json::Value image;
  image["bufferView"] = document.add_view(png.data(), png.size(), 0);
  image["mimeType"] = "image/png";
  document.append("images", image);
  Json::Value sampler;
  sampler["magFilter"] = 9729;  // linear
  sampler["minFilter"] = 9987;  // linear between mipmaps
  sampler["wrapS"] = 33071;     // the border goes on
  sampler["wrapT"] = 33071;
  document.append("samplers", sampler);
  Json::Value reference;
  reference["sampler"] = 0;
  reference["source"] = 0;
  document.append("textures", reference);
  Json::Value material;
  material["name"] = "ground";
  material["doubleSided"] = true;
  auto& surface = material["pbrMetallicRoughness"];
  surface["baseColorTexture"]["index"] = 0;
  surface["metallicFactor"] = 0.0;
  surface["roughnessFactor"] = 0.95;
  document.append("materials", material);
}

void add_scene(const Surface& surface, const ModelOptions& options, const ModelReport& report,
               Document& document) {
  Json::Value node;
  node["name"] = options.name;
  node["mesh"] = 0;
  Json::Value& extras = node["extras"];
  for (const double value : report.origin) extras["origin"].append(value);
  if (!surface.crs_wkt.empty()) extras["crs"] = surface.crs_wkt;
  extras["exaggeration"] = options.exaggeration;
  for (const Note& note : surface.notes) extras[note.name] = note.text;
  document.append("nodes", node);
  Json::Value scene;
  scene["nodes"].append(0);
  document.append("scenes", scene);
  document.json["scene"] = 0;
  document.json["asset"]["version"] = "2.0";
  document.json["asset"]["generator"] = "arete";
}

void write(Document& document, const std::filesystem::path& path) {
  while (document.binary.size() % 4 != 0) document.binary.push_back(0);
  Json::Value buffer;
  buffer["byteLength"] = Json::UInt64(document.binary.size());
  document.append("buffers", buffer);
  Json::StreamWriterBuilder builder;
  builder["indentation"] = "";
  std::string text = Json::writeString(builder, document.json);
  text.resize((text.size() + 3) / 4 * 4, ' ');
  const std::uint64_t total = 12 + 8 + text.size() + 8 + document.binary.size();
  if (total > std::numeric_limits<std::uint32_t>::max())
    throw WriteError("cannot write '" + path.string() +
                     "': a .glb holds at most 4 GiB; write fewer samples");
  const auto size = [](std::uint64_t bytes) { return static_cast<std::uint32_t>(bytes); };
  // Little-endian like every machine VTK runs on; "glTF", version, length; then two chunks.
  const std::array<std::uint32_t, 5> head{0x46546C67, 2, size(total), size(text.size()),
                                          0x4E4F534A};
  const std::array<std::uint32_t, 2> binary_head{size(document.binary.size()), 0x004E4942};
  ModelFile file(path);
  file.write(head.data(), sizeof head);
  file.write(text.data(), text.size());
  file.write(binary_head.data(), sizeof binary_head);
  file.write(document.binary.data(), document.binary.size());
  file.close();
}

}  // namespace

ModelReport write_glb(const Surface& surface, const ModelOptions& options,
                      const std::filesystem::path& path) {
  const Model model = make_model(surface, options);
  Document document;
  add_mesh(options, *model.mesh.data, document);
  add_material(model.texture, path, document);
  add_scene(surface, options, model.report, document);
  write(document, path);
  return model.report;
}

}  // namespace arete::vtk

// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cstring>
#include <functional>
#include <limits>

#include "arete/openmesh/internal/mesh_text.h"

namespace arete::openmesh::detail {
namespace {

static_assert(std::endian::native == std::endian::little, "PLY is written as it lies");

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

Type type_of(const Lines& lines, std::string_view name) {
  constexpr std::pair<std::string_view, Type> names[]{
      {"char", Type::int8},      {"int8", Type::int8},       {"uchar", Type::uint8},
      {"uint8", Type::uint8},    {"short", Type::int16},     {"int16", Type::int16},
      {"ushort", Type::uint16},  {"uint16", Type::uint16},   {"int", Type::int32},
      {"int32", Type::int32},    {"uint", Type::uint32},     {"uint32", Type::uint32},
      {"float", Type::float32},  {"float32", Type::float32}, {"double", Type::float64},
      {"float64", Type::float64}};
  for (const auto& [known, type] : names)
    if (name == known) return type;
  lines.fail("'" + std::string(name) + "' is no PLY type");
}

struct Property {
  std::string name;
  Type type = Type::float32;
  bool list = false;
  Type count_type = Type::uint8;
};

struct Element {
  std::string name;
  std::size_t count = 0;
  std::vector<Property> properties;
};

enum class Coding { text, little, big };

// The numbers after the header, one after the other.
class Body {
 public:
  Body(std::string_view bytes, Coding coding) : bytes_(bytes), lines_(bytes), coding_(coding) {}

  double next(Type type) {
    if (coding_ == Coding::text) return next_word();
    switch (type) {
      case Type::int8:
        return raw<std::int8_t>();
      case Type::uint8:
        return raw<std::uint8_t>();
      case Type::int16:
        return raw<std::int16_t>();
      case Type::uint16:
        return raw<std::uint16_t>();
      case Type::int32:
        return raw<std::int32_t>();
      case Type::uint32:
        return raw<std::uint32_t>();
      case Type::float32:
        return raw<float>();
      default:
        return raw<double>();
    }
  }

 private:
  double next_word() {
    while (word_ >= lines_.size()) {
      if (!lines_.next()) throw MeshFileError("the file ends too early");
      word_ = 0;
    }
    return lines_.number<double>(word_++);
  }
  template <class T>
  double raw() {
    if (bytes_.size() - position_ < sizeof(T)) throw MeshFileError("the file ends too early");
    char buffer[sizeof(T)];
    std::memcpy(buffer, bytes_.data() + position_, sizeof(T));
    position_ += sizeof(T);
    if (coding_ == Coding::big) std::reverse(buffer, buffer + sizeof(T));
    T value;
    std::memcpy(&value, buffer, sizeof(T));
    return static_cast<double>(value);
  }

  std::string_view bytes_;
  Lines lines_;
  Coding coding_;
  std::size_t position_ = 0;
  std::size_t word_ = 0;
};

struct Header {
  Coding coding = Coding::text;
  std::vector<Element> elements;
  std::size_t size = 0;
};

Header parse_header(std::string_view bytes) {
  Lines lines(bytes);
  if (!lines.next() || lines.words()[0] != "ply") lines.fail("ply is expected here");
  Header header;
  while (lines.next()) {
    const auto& words = lines.words();
    if (words[0] == "end_header") {
      header.size = lines.position();
      return header;
    }
    if (words[0] == "format" && lines.size() > 1) {
      if (words[1] == "ascii")
        header.coding = Coding::text;
      else if (words[1] == "binary_little_endian")
        header.coding = Coding::little;
      else if (words[1] == "binary_big_endian")
        header.coding = Coding::big;
      else
        lines.fail("'" + std::string(words[1]) + "' is no PLY format");
    } else if (words[0] == "element" && lines.size() > 2) {
      // A second list of vertices would leave attributes of the first without vertices, or the
      // reverse.
      for (const Element& element : header.elements)
        if (element.name == words[1]) lines.fail("element " + element.name + " is there twice");
      header.elements.push_back({std::string(words[1]), lines.number<std::size_t>(2), {}});
    } else if (words[0] == "property" && lines.size() > 2 && !header.elements.empty()) {
      Property property;
      property.name = words.back();
      property.list = words[1] == "list";
      if (property.list) {
        if (lines.size() < 5) lines.fail("a list needs two types and a name");
        property.count_type = type_of(lines, words[2]);
      }
      property.type = type_of(lines, words[property.list ? 3 : 1]);
      header.elements.back().properties.push_back(property);
    } else if (words[0] != "comment" && words[0] != "obj_info") {
      lines.fail("'" + std::string(words[0]) + "' does not belong here");
    }
  }
  throw MeshFileError("the header does not end");
}

// Where a number of a vertex goes; nothing for those that are not used.
using Store = std::function<void(double)>;

Store vertex_store(MeshData& mesh, const Property& property) {
  const auto among = [&](std::initializer_list<const char*> names) {
    return std::find(names.begin(), names.end(), property.name) != names.end();
  };
  const bool fraction = property.type == Type::float32 || property.type == Type::float64;
  for (std::size_t k = 0; k < 3; ++k)
    if (property.name == std::string(1, "xyz"[k]))
      return [&mesh, k](double x) { mesh.points.back()[k] = x; };
  for (std::size_t k = 0; k < 3; ++k)
    if (property.name == std::string("n") + "xyz"[k])
      return [&mesh, k](double x) {
        mesh.normals.resize(mesh.points.size());
        mesh.normals.back()[k] = static_cast<float>(x);
      };
  constexpr const char* colors[]{"red", "green", "blue", "alpha"};
  for (std::size_t k = 0; k < 4; ++k)
    if (property.name == colors[k])
      return [&mesh, k, fraction](double x) {
        mesh.colors.resize(mesh.points.size(), {0, 0, 0, 255});
        mesh.colors.back()[k] = color_byte(fraction ? x : x / 255);
      };
  const bool u = among({"s", "u", "texture_u"});
  if (u || among({"t", "v", "texture_v"}))
    return [&mesh, u](double x) {
      mesh.texcoords.resize(mesh.points.size());
      mesh.texcoords.back()[u ? 0 : 1] = static_cast<float>(x);
    };
  return {};
}

int checked_index(double x) {
  if (!(x >= -2147483648.0 && x <= 2147483647.0))
    throw MeshFileError("a vertex number is too large");
  return static_cast<int>(x);
}

// The corners of one face, and their texture coordinates (two numbers a corner) if it has any.
struct Face {
  std::vector<int> corners;
  std::vector<double> texcoords;
};

void read_list(Body& body, const Property& property, Face& face) {
  const double count = body.next(property.count_type);
  if (!(count >= 0 && count <= std::numeric_limits<int>::max()))
    throw MeshFileError("a list has " + std::to_string(count) + " entries");
  const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
  const bool texcoords = property.name == "texcoord";
  for (double n = 0; n < count; ++n) {
    const double x = body.next(property.type);
    if (corners) face.corners.push_back(checked_index(x));
    if (texcoords) face.texcoords.push_back(x);
  }
}

void add_face(const Face& face, MeshData& mesh) {
  if (face.corners.empty()) return;
  mesh.faces.add(face.corners);
  if (face.texcoords.size() != 2 * face.corners.size()) return;
  mesh.corner_texcoords.resize(mesh.faces.corners.size() - face.corners.size());
  for (std::size_t i = 0; i < face.texcoords.size(); i += 2)
    mesh.corner_texcoords.push_back(
        {static_cast<float>(face.texcoords[i]), static_cast<float>(face.texcoords[i + 1])});
}

void read_element(Body& body, const Element& element, MeshData& mesh) {
  const bool vertices = element.name == "vertex";
  std::vector<Store> stores;
  for (const Property& property : element.properties)
    stores.push_back(vertices && !property.list ? vertex_store(mesh, property) : Store{});
  Face face;
  for (std::size_t i = 0; i < element.count; ++i) {
    if (vertices) mesh.points.push_back({});
    face.corners.clear();
    face.texcoords.clear();
    for (std::size_t k = 0; k < stores.size(); ++k) {
      const Property& property = element.properties[k];
      if (property.list) {
        read_list(body, property, face);
        continue;
      }
      const double x = body.next(property.type);
      if (stores[k]) stores[k](x);
    }
    if (element.name == "face") add_face(face, mesh);
  }
}

template <class T>
void append_raw(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

}  // namespace

MeshData parse_ply(std::string_view bytes) {
  const Header header = parse_header(bytes);
  Body body(bytes.substr(header.size), header.coding);
  MeshData mesh;
  for (const Element& element : header.elements) {
    // Nothing of it is in the file, so that the file's length would not bound its number.
    if (element.properties.empty() && element.count > 0)
      throw MeshFileError("element " + element.name + " has no property");
    read_element(body, element, mesh);
  }
  if (!mesh.corner_texcoords.empty()) mesh.corner_texcoords.resize(mesh.faces.corners.size());
  return mesh;
}

void write_ply(const MeshData& mesh, Output& out) {
  std::string& bytes = out.text;
  bytes = "ply\nformat binary_little_endian 1.0\n";
  out.comments("comment ");
  bytes += "element vertex ";
  append(bytes, mesh.points.size());
  const char* const real = out.single_precision ? "float " : "double ";
  for (const char* name : {"x", "y", "z"}) bytes += std::string("\nproperty ") + real + name;
  if (!mesh.normals.empty()) bytes += "\nproperty float nx\nproperty float ny\nproperty float nz";
  if (!mesh.colors.empty())
    for (const char* name : {"red", "green", "blue", "alpha"})
      bytes += std::string("\nproperty uchar ") + name;
  if (!mesh.texcoords.empty()) bytes += "\nproperty float s\nproperty float t";
  append(bytes += "\nelement face ", mesh.faces.count());
  bytes += "\nproperty list uchar int vertex_indices";
  const bool at_corners = !mesh.corner_texcoords.empty();
  if (at_corners) bytes += "\nproperty list uchar float texcoord";
  bytes += "\nend_header\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (double x : mesh.points[v]) {
      if (out.single_precision)
        append_raw(bytes, static_cast<float>(x));
      else
        append_raw(bytes, x);
    }
    if (!mesh.normals.empty())
      for (float x : mesh.normals[v]) append_raw(bytes, x);
    if (!mesh.colors.empty())
      for (std::uint8_t c : mesh.colors[v]) append_raw(bytes, c);
    if (!mesh.texcoords.empty())
      for (float t : mesh.texcoords[v]) append_raw(bytes, t);
    out.record_done();
  }
  for (int f = 0; f < mesh.faces.count(); ++f) {
    const auto face = mesh.faces[f];
    if (face.size() > (at_corners ? 127u : 255u))
      throw MeshFileError("face " + std::to_string(f) + " has more corners than PLY counts here");
    append_raw(bytes, static_cast<std::uint8_t>(face.size()));
    for (int v : face) append_raw(bytes, static_cast<std::int32_t>(v));
    if (at_corners) {
      append_raw(bytes, static_cast<std::uint8_t>(2 * face.size()));
      const auto first = static_cast<std::size_t>(mesh.faces.starts[static_cast<std::size_t>(f)]);
      for (std::size_t i = 0; i < face.size(); ++i)
        for (float t : mesh.corner_texcoords[first + i]) append_raw(bytes, t);
    }
    out.record_done();
  }
}

}  // namespace arete::openmesh::detail

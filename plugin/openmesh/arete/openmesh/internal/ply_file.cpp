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

void read_element(Body& body, const Element& element, MeshData& mesh) {
  const bool vertices = element.name == "vertex";
  std::vector<Store> stores;
  for (const Property& property : element.properties)
    stores.push_back(vertices && !property.list ? vertex_store(mesh, property) : Store{});
  std::vector<int> face;
  for (std::size_t i = 0; i < element.count; ++i) {
    if (vertices) mesh.points.push_back({});
    for (std::size_t k = 0; k < stores.size(); ++k) {
      const Property& property = element.properties[k];
      if (!property.list) {
        const double x = body.next(property.type);
        if (stores[k]) stores[k](x);
        continue;
      }
      const double count = body.next(property.count_type);
      if (!(count >= 0 && count <= std::numeric_limits<int>::max()))
        throw MeshFileError("a list has " + std::to_string(count) + " entries");
      const bool corners = element.name == "face" &&
                           (property.name == "vertex_indices" || property.name == "vertex_index");
      face.clear();
      for (double n = 0; n < count; ++n) {
        const double x = body.next(property.type);
        if (corners) face.push_back(checked_index(x));
      }
      if (corners) mesh.faces.add(face);
    }
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
  for (const Element& element : header.elements) read_element(body, element, mesh);
  return mesh;
}

std::string ply_bytes(const MeshData& mesh) {
  std::string bytes = "ply\nformat binary_little_endian 1.0\nelement vertex ";
  append(bytes, mesh.points.size());
  bytes += "\nproperty double x\nproperty double y\nproperty double z\n";
  if (!mesh.colors.empty())
    for (const char* name : {"red", "green", "blue", "alpha"})
      bytes += "property uchar " + std::string(name) + "\n";
  if (!mesh.texcoords.empty()) bytes += "property float s\nproperty float t\n";
  append(bytes += "element face ", mesh.faces.count());
  bytes += "\nproperty list uchar int vertex_indices\nend_header\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    for (double x : mesh.points[v]) append_raw(bytes, x);
    if (!mesh.colors.empty())
      for (std::uint8_t c : mesh.colors[v]) append_raw(bytes, c);
    if (!mesh.texcoords.empty())
      for (float t : mesh.texcoords[v]) append_raw(bytes, t);
  }
  for (int f = 0; f < mesh.faces.count(); ++f) {
    if (mesh.faces[f].size() > 255)
      throw MeshFileError("face " + std::to_string(f) + " has more than 255 corners");
    append_raw(bytes, static_cast<std::uint8_t>(mesh.faces[f].size()));
    for (int v : mesh.faces[f]) append_raw(bytes, static_cast<std::int32_t>(v));
  }
  return bytes;
}

}  // namespace arete::openmesh::detail

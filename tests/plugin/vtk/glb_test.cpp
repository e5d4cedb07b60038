// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <vtkGLTFReader.h>
#include <vtkImageData.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>

#include "arete/vtk/error.h"
#include "arete/vtk/write_model.h"
#include "fixtures.h"
#include "models.h"
#include "reading.h"

namespace arete::vtk {
namespace {

using Json = nlohmann::json;

/// A .glb taken apart by the letter of its specification.
struct Glb {
  Json json;
  std::string binary;

  explicit Glb(const std::filesystem::path& path) {
    const std::string bytes = contents(path);
    const auto word = [&](std::size_t at) {
      std::uint32_t value = 0;
      std::memcpy(&value, bytes.data() + at, 4);
      return value;
    };
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(word(4), 2u);
    EXPECT_EQ(word(8), bytes.size());
    const std::size_t json_size = word(12);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    EXPECT_EQ(json_size % 4, 0u);
    json = Json::parse(bytes.substr(20, json_size));
    const std::size_t binary_size = word(20 + json_size);
    EXPECT_EQ(bytes.substr(24 + json_size, 4), std::string("BIN\0", 4));
    EXPECT_EQ(binary_size % 4, 0u);
    EXPECT_EQ(28 + json_size + binary_size, bytes.size()) << "and nothing after";
    binary = bytes.substr(28 + json_size);
  }

  [[nodiscard]] std::string view(std::size_t index) const {
    const Json& view = json.at("bufferViews").at(index);
    EXPECT_EQ(view.at("byteOffset").get<std::size_t>() % 4, 0u);
    return binary.substr(view.at("byteOffset"), view.at("byteLength"));
  }
  template <class T>
  [[nodiscard]] std::vector<T> values(std::size_t accessor) const {
    const Json& entry = json.at("accessors").at(accessor);
    const std::string bytes = view(entry.at("bufferView"));
    const std::string type = entry.at("type");
    const std::size_t components = type == "VEC3" ? 3 : type == "VEC2" ? 2 : 1;
    EXPECT_EQ(bytes.size(), entry.at("count").get<std::size_t>() * components * sizeof(T));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
  }
  [[nodiscard]] const Json& primitive() const {
    return json.at("meshes").at(0).at("primitives").at(0);
  }
};

TEST(glb, vtk_s_own_reader_finds_every_sample_in_its_place) {
  const Scratch scratch;
  const auto grid = planted<double>({5, 7}, north_up, plane_height);
  ModelOptions options;
  options.exaggeration = 2;
  const ModelReport report = write_glb(surface_of(grid, north_up), options, scratch / "a.glb");
  EXPECT_EQ(report.vertices, 35);
  EXPECT_EQ(report.quads, 24);
  const vtkSmartPointer<vtkPolyData> mesh = first_mesh(read_back<vtkGLTFReader>(scratch / "a.glb"));
  ASSERT_NE(mesh, nullptr);
  ASSERT_EQ(mesh->GetNumberOfPoints(), 35);
  EXPECT_EQ(mesh->GetNumberOfPolys(), 48) << "two triangles a quad";
  for (vtkIdType k = 0; k < 35; ++k) {
    const Vector3 at = point(*mesh, k);  // x east, y up, -z north
    const double x = at[0] + report.origin[0];
    const double y = -at[2] + report.origin[1];
    const double z = at[1] / 2 + report.origin[2];
    EXPECT_NEAR(z, plane_height(x, y), 1e-4);
    const WorldPoint expected =
        north_up.position(static_cast<double>(k / 7), static_cast<double>(k % 7));
    EXPECT_NEAR(x, expected.x, 1e-5);
    EXPECT_NEAR(y, expected.y, 1e-5);
  }
}

TEST(glb, triangles_face_upwards_and_normals_are_those_of_the_plane) {
  const Scratch scratch;
  for (const Georeference& georeference : {north_up, south_up, mirrored, rotated}) {
    const auto grid = planted<float>({6, 5}, georeference, plane_height);
    write_glb(surface_of(grid, georeference), {}, scratch / "a.glb");
    const Glb glb(scratch / "a.glb");
    const auto& attributes = glb.primitive().at("attributes");
    const auto points = glb.values<float>(attributes.at("POSITION"));
    const auto normals = glb.values<float>(attributes.at("NORMAL"));
    const auto corners = glb.values<std::uint32_t>(glb.primitive().at("indices"));
    // z = 3 x - 2 y: (-3, 2, 1) / |.| with z up, (-3, 1, -2) with y up.
    const double length = std::sqrt(14.0);
    for (std::size_t k = 0; k < normals.size(); k += 3) {
      EXPECT_NEAR(normals[k], -3 / length, 1e-5);
      EXPECT_NEAR(normals[k + 1], 1 / length, 1e-5);
      EXPECT_NEAR(normals[k + 2], -2 / length, 1e-5);
    }
    ASSERT_EQ(corners.size(), 5u * 4 * 6);
    for (std::size_t t = 0; t < corners.size(); t += 3) {
      const auto at = [&](std::size_t k, std::size_t c) {
        return static_cast<double>(points[3 * corners[t + k] + c]);
      };
      const double ux = at(1, 0) - at(0, 0);
      const double uz = at(1, 2) - at(0, 2);
      const double vx = at(2, 0) - at(0, 0);
      const double vz = at(2, 2) - at(0, 2);
      EXPECT_GT(uz * vx - ux * vz, 0) << "counter-clockwise from above";
    }
  }
}

TEST(glb, bounds_are_those_of_the_points_to_the_last_bit) {
  const Scratch scratch;
  const auto grid = planted<double>({9, 8}, utm, [](double x, double y) {
    return 700 + 0.1 * (x - 399960) - 0.3 * (y - 5300040);
  });
  write_glb(surface_of(grid, utm), {}, scratch / "a.glb");
  const Glb glb(scratch / "a.glb");
  const Json& accessor =
      glb.json.at("accessors")
          .at(glb.primitive().at("attributes").at("POSITION").get<std::size_t>());
  const auto points = glb.values<float>(0);
  for (std::size_t c = 0; c < 3; ++c) {
    float low = points[c];
    float high = points[c];
    for (std::size_t k = c; k < points.size(); k += 3) {
      low = std::min(low, points[k]);
      high = std::max(high, points[k]);
    }
    EXPECT_EQ(accessor.at("min").at(c).get<float>(), low);
    EXPECT_EQ(accessor.at("max").at(c).get<float>(), high);
  }
}

TEST(glb, the_texture_lies_in_the_file_with_its_corner_pixel_at_the_corner_sample) {
  const Scratch scratch;
  const auto grid = planted<float>({4, 4}, north_up, plane_height);
  const Image four = four_colors(8);
  ModelOptions options;
  options.appearance.texture = Texture{four};
  write_glb(surface_of(grid, north_up), options, scratch / "a.glb");
  const Glb glb(scratch / "a.glb");
  ASSERT_EQ(glb.json.at("images").size(), 1u);
  EXPECT_EQ(glb.json.at("images").at(0).at("mimeType"), "image/png");
  EXPECT_FALSE(glb.json.at("images").at(0).contains("uri")) << "in the file, not beside it";
  std::ofstream(scratch / "t.png", std::ios::binary)
      << glb.view(glb.json.at("images").at(0).at("bufferView"));
  EXPECT_EQ(read_png(scratch / "t.png").pixels, four.pixels);

  vtkNew<vtkGLTFReader> reader;
  reader->SetFileName((scratch / "a.glb").string().c_str());
  reader->Update();
  ASSERT_EQ(reader->GetNumberOfTextures(), 1);
  EXPECT_EQ(reader->GetGLTFTexture(0).Image->GetDimensions()[0], 8) << "VTK finds it too";

  const auto uv = glb.values<float>(glb.primitive().at("attributes").at("TEXCOORD_0"));
  ASSERT_EQ(uv.size(), 32u);
  for (std::size_t k = 0; k < 16; ++k) {
    // Row 0 is north, and glTF's v runs down from the texture's first row.
    EXPECT_FLOAT_EQ(uv[2 * k], (static_cast<float>(k % 4) + 0.5F) / 4);
    EXPECT_FLOAT_EQ(uv[2 * k + 1], (static_cast<float>(k / 4) + 0.5F) / 4);
  }
  const Json& material =
      glb.json.at("materials").at(glb.primitive().at("material").get<std::size_t>());
  const std::size_t texture =
      material.at("pbrMetallicRoughness").at("baseColorTexture").at("index");
  EXPECT_EQ(glb.json.at("textures").at(texture).at("source"), 0);
  EXPECT_EQ(material.at("pbrMetallicRoughness").at("metallicFactor"), 0);
}

TEST(glb, without_a_texture_the_colours_of_the_heights_are_one) {
  const Scratch scratch;
  const auto grid = planted<float>({3, 5}, north_up, [](double x, double) { return x; });
  ModelOptions options;
  options.appearance.colormap = "viridis";
  write_glb(surface_of(grid, north_up), options, scratch / "a.glb");
  const Glb glb(scratch / "a.glb");
  std::ofstream(scratch / "t.png", std::ios::binary)
      << glb.view(glb.json.at("images").at(0).at("bufferView"));
  const Image image = read_png(scratch / "t.png");
  ASSERT_EQ(image.width, 5);
  ASSERT_EQ(image.height, 3);
  for (int y = 0; y < 3; ++y) {
    for (int x = 0; x < 5; ++x) EXPECT_EQ(image(x, y), find_colormap("viridis")(x / 4.0));
  }
}

TEST(glb, says_where_on_earth_it_belongs) {
  const Scratch scratch;
  const auto grid = planted<double>({3, 3}, utm, [](double, double) { return 250; });
  Surface surface = surface_of(grid, utm);
  surface.crs_wkt = "PROJCRS[\"a \\ b\"]";
  surface.notes = {{"arete_scheme", "gentle"}};
  write_glb(surface, {.name = "hill"}, scratch / "a.glb");
  const Json node = Glb(scratch / "a.glb").json.at("nodes").at(0);
  EXPECT_EQ(node.at("name"), "hill");
  EXPECT_EQ(node.at("extras").at("crs"), surface.crs_wkt);
  EXPECT_EQ(node.at("extras").at("arete_scheme"), "gentle");
  const WorldPoint centre = utm.position(1, 1);
  EXPECT_EQ(node.at("extras").at("origin"), (Json{centre.x, centre.y, 250.0}));
}

TEST(glb, quads_beside_a_hole_are_left_out_and_so_are_their_lonely_samples) {
  const Scratch scratch;
  auto grid = planted<float>({5, 5}, north_up, plane_height);
  grid(0, 0) = missing;
  grid(2, 2) = missing;
  const ModelReport report = write_glb(surface_of(grid, north_up), {}, scratch / "a.glb");
  EXPECT_EQ(report.quads, 16 - 1 - 4);
  EXPECT_EQ(report.vertices, 23);
}

TEST(glb, refuses_what_cannot_be_a_model) {
  const Scratch scratch;
  const auto grid = planted<float>({5, 5}, north_up, plane_height);
  ModelOptions flat;
  flat.exaggeration = 0;
  EXPECT_THROW(write_glb(surface_of(grid, north_up), flat, scratch / "a.glb"), RenderError);
  const Grid<float> line({1, 9}, 2);
  EXPECT_THROW(write_glb(surface_of(line, north_up), {}, scratch / "a.glb"), InvalidField);
  EXPECT_FALSE(std::filesystem::exists(scratch / "a.glb"));
  EXPECT_THROW(write_glb(surface_of(grid, north_up), {}, scratch / "none/a.glb"), WriteError);
}

}  // namespace
}  // namespace arete::vtk

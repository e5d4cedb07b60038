// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkOBJReader.h>
#include <vtkPointData.h>

#include <cmath>
#include <sstream>

#include "arete/vtk/error.h"
#include "arete/vtk/write_model.h"
#include "fixtures.h"
#include "models.h"
#include "reading.h"

namespace arete::vtk {
namespace {

ObjFiles files_in(const Scratch& scratch) {
  return {scratch / "a.obj", scratch / "a.mtl", scratch / "a.png", "a.mtl", "a.png"};
}

TEST(obj, vtk_s_own_reader_finds_quads_normals_and_texture_coordinates) {
  const Scratch scratch;
  const auto grid = planted<double>({5, 7}, utm, plane_height);
  const ModelReport report = write_obj(surface_of(grid, utm), {}, files_in(scratch));
  const auto mesh = read_back<vtkOBJReader>(scratch / "a.obj");
  ASSERT_EQ(mesh->GetNumberOfPoints(), 35);
  ASSERT_EQ(mesh->GetNumberOfPolys(), 24);
  EXPECT_EQ(mesh->GetMaxCellSize(), 4) << "quads stay quads";
  vtkDataArray& normals = *mesh->GetPointData()->GetNormals();
  vtkDataArray& on_texture = *mesh->GetPointData()->GetTCoords();
  for (vtkIdType k = 0; k < 35; ++k) {
    const Vector3 at = point(*mesh, k);
    EXPECT_NEAR(at[2] + report.origin[2],
                plane_height(at[0] + report.origin[0], at[1] + report.origin[1]), 1e-4);
    const WorldPoint expected =
        utm.position(static_cast<double>(k / 7), static_cast<double>(k % 7));
    EXPECT_NEAR(at[0] + report.origin[0], expected.x, 1e-5) << "metres of a UTM zone";
    EXPECT_NEAR(at[1] + report.origin[1], expected.y, 1e-5);
    EXPECT_NEAR(normals.GetComponent(k, 2), 1 / std::sqrt(14.0), 1e-5);
    EXPECT_NEAR(normals.GetComponent(k, 0), -3 / std::sqrt(14.0), 1e-5);
    EXPECT_NEAR(on_texture.GetComponent(k, 0), (static_cast<double>(k % 7) + 0.5) / 7, 1e-6);
    EXPECT_NEAR(on_texture.GetComponent(k, 1), 1 - (static_cast<double>(k / 7) + 0.5) / 5, 1e-6)
        << "v runs up in an OBJ";
  }
}

TEST(obj, names_its_material_and_that_its_texture) {
  const Scratch scratch;
  const auto grid = planted<float>({4, 4}, north_up, plane_height);
  ModelOptions options;
  options.appearance.texture = Texture{four_colors(16)};
  write_obj(surface_of(grid, north_up), options, files_in(scratch));
  const std::string obj = contents(scratch / "a.obj");
  EXPECT_NE(obj.find("\nmtllib a.mtl\n"), std::string::npos);
  EXPECT_NE(obj.find("\nusemtl ground\n"), std::string::npos);
  const std::string mtl = contents(scratch / "a.mtl");
  EXPECT_NE(mtl.find("\nnewmtl ground\n"), std::string::npos);
  EXPECT_NE(mtl.find("\nmap_Kd a.png\n"), std::string::npos);
  EXPECT_EQ(mtl.find("Tr "), std::string::npos) << "of which programs disagree what is clear";
  EXPECT_EQ(read_png(scratch / "a.png").pixels, four_colors(16).pixels);
}

TEST(obj, numbers_come_back_to_the_last_bit) {
  const Scratch scratch;
  const Georeference thirds{{0, 1.0 / 3, 0, 0, 0, -1.0 / 7}};
  const auto grid =
      planted<float>({6, 6}, thirds, [](double x, double y) { return std::sin(x) / 3 + y; });
  write_obj(surface_of(grid, thirds), {}, files_in(scratch));
  std::istringstream lines(contents(scratch / "a.obj"));
  std::string line;
  Index vertex = 0;
  const Index half = 5;  // (6 - 1) / 2 samples twice
  while (std::getline(lines, line)) {
    if (line.rfind("v ", 0) != 0) continue;
    std::istringstream numbers(line.substr(2));
    double x = 0;
    numbers >> x;
    const double expected = static_cast<double>(2 * (vertex % 6) - half) / 2 / 3;
    EXPECT_NEAR(x, expected, std::abs(expected) * 1e-7);
    ++vertex;
  }
  EXPECT_EQ(vertex, 36);
}

TEST(obj, a_full_folder_or_none_is_named) {
  const Scratch scratch;
  const auto grid = planted<float>({4, 4}, north_up, plane_height);
  ObjFiles files = files_in(scratch);
  files.mtl = scratch / "none/a.mtl";
  try {
    write_obj(surface_of(grid, north_up), {}, files);
    ADD_FAILURE();
  } catch (const WriteError& error) {
    EXPECT_NE(std::string(error.what()).find("none/a.mtl"), std::string::npos);
  }
  files.obj = "/dev/full";
  EXPECT_THROW(write_obj(surface_of(grid, north_up), {}, files), WriteError);
}

}  // namespace
}  // namespace arete::vtk

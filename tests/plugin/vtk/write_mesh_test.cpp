// SPDX-License-Identifier: MIT
#include "arete/vtk/write_mesh.h"

#include <gtest/gtest.h>
#include <vtkCell.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataReader.h>

#include "reading.h"
#include "support/temporary_folder.h"
#include "topology/meshes.h"

namespace arete::vtk {
namespace {

TEST(write_mesh, vtk_reads_back_faces_points_and_attributes) {
  const test::TemporaryFolder folder;
  const test::Mesh mesh = test::shuffled(test::terrain_mesh(3, 4), 1);
  std::vector<std::array<float, 3>> normals;
  std::vector<std::array<std::uint8_t, 4>> colors;
  std::vector<std::array<float, 2>> texcoords;
  for (int v = 0; v < mesh.vertices(); ++v) {
    normals.push_back({0, 0.6f, 0.8f});
    colors.push_back({static_cast<std::uint8_t>(v), 2, 3, 4});
    texcoords.push_back({static_cast<float>(v) / 4, 1});
  }
  PolygonMesh polygons{mesh.points, mesh.faces, normals, colors, texcoords};
  polygons.notes = {{"arete_scheme", "gentle"}};
  write_mesh(polygons, folder.file("m.vtp"));
  const auto data = read_back<vtkXMLPolyDataReader>(folder.file("m.vtp"));
  ASSERT_EQ(data->GetNumberOfPoints(), mesh.vertices());
  ASSERT_EQ(data->GetNumberOfPolys(), mesh.faces.count());
  for (int v = 0; v < mesh.vertices(); ++v)
    for (int k = 0; k < 3; ++k)
      EXPECT_EQ(data->GetPoint(v)[k],
                mesh.points[static_cast<std::size_t>(v)][static_cast<std::size_t>(k)]);
  for (int f = 0; f < mesh.faces.count(); ++f) {
    ASSERT_EQ(data->GetCell(f)->GetNumberOfPoints(), 4);
    for (int i = 0; i < 4; ++i)
      EXPECT_EQ(data->GetCell(f)->GetPointId(i), mesh.faces[f][static_cast<std::size_t>(i)]);
  }
  EXPECT_FLOAT_EQ(static_cast<float>(data->GetPointData()->GetNormals()->GetComponent(5, 2)), 0.8f);
  EXPECT_EQ(data->GetPointData()->GetArray("RGBA")->GetComponent(7, 0), 7);
  EXPECT_EQ(data->GetPointData()->GetTCoords()->GetComponent(6, 0), 1.5);
  EXPECT_EQ(field_text(*data, "arete_scheme"), "gentle");
}

TEST(write_mesh, what_does_not_fit_is_refused) {
  const test::TemporaryFolder folder;
  test::Mesh mesh = test::terrain_mesh(3, 3);
  const std::vector<std::array<float, 3>> two_normals(2);
  EXPECT_THROW(write_mesh({mesh.points, mesh.faces, two_normals}, folder.file("m.vtp")),
               InvalidField);
  const FaceList none;
  EXPECT_THROW(write_mesh({mesh.points, none}, folder.file("m.vtp")), InvalidField);
  mesh.faces.add(std::vector<int>{0, 1, 9});
  EXPECT_THROW(write_mesh({mesh.points, mesh.faces}, folder.file("m.vtp")), InvalidField);
  EXPECT_EQ(folder.entries(), 0);
}

}  // namespace
}  // namespace arete::vtk

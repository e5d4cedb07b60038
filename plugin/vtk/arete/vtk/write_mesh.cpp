// SPDX-License-Identifier: MIT
#include "arete/vtk/write_mesh.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>
#include <vtkTypeInt32Array.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataWriter.h>

#include <algorithm>
#include <string>

#include "arete/vtk/internal/field_data.h"
#include "arete/vtk/internal/xml_file.h"

namespace arete::vtk {
namespace {

void check(const PolygonMesh& mesh) {
  if (mesh.faces.count() == 0) throw InvalidField("a mesh without faces cannot be drawn");
  const auto vertices = static_cast<int>(mesh.points.size());
  for (int v : mesh.faces.corners)
    if (v < 0 || v >= vertices)
      throw InvalidField("a face names vertex " + std::to_string(v) + " of " +
                         std::to_string(vertices));
  for (const std::size_t count : {mesh.normals.size(), mesh.colors.size(), mesh.texcoords.size()})
    if (count != 0 && count != mesh.points.size())
      throw InvalidField("an attribute has " + std::to_string(count) + " entries for " +
                         std::to_string(mesh.points.size()) + " vertices");
}

template <class Array, class Vector>
vtkSmartPointer<Array> array_of(std::span<const Vector> vectors, const char* name) {
  const auto array = vtkSmartPointer<Array>::New();
  array->SetName(name);
  array->SetNumberOfComponents(static_cast<int>(Vector{}.size()));
  array->SetNumberOfTuples(static_cast<vtkIdType>(vectors.size()));
  auto* out = array->GetPointer(0);
  for (const Vector& vector : vectors) out = std::copy(vector.begin(), vector.end(), out);
  return array;
}

}  // namespace

void write_mesh(const PolygonMesh& mesh, const std::filesystem::path& path,
                const WriteOptions& options) {
  check(mesh);
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(static_cast<vtkIdType>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
    points->SetPoint(static_cast<vtkIdType>(v), mesh.points[v].data());
  vtkNew<vtkTypeInt32Array> offsets;
  vtkNew<vtkTypeInt32Array> corners;
  const auto fill = [](vtkTypeInt32Array& array, const std::vector<int>& numbers) {
    array.SetNumberOfValues(static_cast<vtkIdType>(numbers.size()));
    std::copy(numbers.begin(), numbers.end(), array.GetPointer(0));
  };
  fill(*offsets, mesh.faces.starts);
  fill(*corners, mesh.faces.corners);
  vtkNew<vtkCellArray> cells;
  cells->SetData(offsets, corners);

  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetPolys(cells);
  if (!mesh.normals.empty())
    data->GetPointData()->SetNormals(array_of<vtkFloatArray>(mesh.normals, "Normals"));
  if (!mesh.colors.empty())
    data->GetPointData()->SetScalars(array_of<vtkUnsignedCharArray>(mesh.colors, "RGBA"));
  if (!mesh.texcoords.empty())
    data->GetPointData()->SetTCoords(array_of<vtkFloatArray>(mesh.texcoords, "TextureCoordinates"));
  for (const Note& note : mesh.notes) add_text(note.name, note.text, *data);
  vtkNew<vtkXMLPolyDataWriter> writer;
  write_xml(*writer, *data, path, options);
}

}  // namespace arete::vtk

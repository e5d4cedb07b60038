// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/field_data.h"

#include <vtkDataObject.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkNew.h>
#include <vtkStringArray.h>

namespace arete::vtk {

void add_text(const std::string& name, const std::string& text, vtkDataObject& out) {
  vtkNew<vtkStringArray> array;
  array->SetName(name.c_str());
  array->InsertNextValue(text);
  out.GetFieldData()->AddArray(array);
}

void add_field_data(const Surface& surface, vtkDataObject& out) {
  for (const Note& note : surface.notes) add_text(note.name, note.text, out);
  if (!surface.crs_wkt.empty()) add_text("CRS_WKT", surface.crs_wkt, out);
  vtkNew<vtkDoubleArray> map;
  map->SetName("GeoTransform");
  for (const double value : surface.georeference.affine) map->InsertNextValue(value);
  out.GetFieldData()->AddArray(map);
}

void add_field_data(const Surface& surface, const LocalPlane& plane, vtkDataObject& out) {
  add_field_data(surface, out);
  if (!plane.note.empty()) add_text("local_plane", plane.note, out);
}

}  // namespace arete::vtk

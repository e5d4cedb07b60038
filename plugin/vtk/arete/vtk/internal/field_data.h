// SPDX-License-Identifier: MIT
#pragma once

#include "arete/vtk/internal/local_plane.h"
#include "arete/vtk/surface.h"

class vtkDataObject;

namespace arete::vtk {

/// A text in the field data, under its name.
void add_text(const std::string& name, const std::string& text, vtkDataObject& out);

/// What a VTK file has no other place for, as field data: the reference system ("CRS_WKT"), the
/// caller's notes, and the map of samples to world coordinates ("GeoTransform", GDAL's six numbers
/// for the raster as given, row 0 first).
void add_field_data(const Surface& surface, vtkDataObject& out);

/// The same, and what x and y mean ("local_plane") if they are not the world coordinates.
void add_field_data(const Surface& surface, const LocalPlane& plane, vtkDataObject& out);

}  // namespace arete::vtk

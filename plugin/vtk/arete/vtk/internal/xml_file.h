// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "arete/vtk/write_options.h"

class vtkDataObject;
class vtkXMLWriter;

namespace arete::vtk {

/// Writes `data` to exactly this path. Whatever VTK complains about, or keeps to itself, ends up in
/// the exception and not on stderr.
/// \throws WriteError
void write_xml(vtkXMLWriter& writer, vtkDataObject& data, const std::filesystem::path& path,
               const WriteOptions& options);

}  // namespace arete::vtk

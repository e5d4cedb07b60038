// SPDX-License-Identifier: MIT
#include "arete/vtk/internal/xml_file.h"

#include <vtkDataObject.h>
#include <vtkExecutive.h>
#include <vtkLZ4DataCompressor.h>
#include <vtkNew.h>
#include <vtkXMLWriter.h>
#include <vtkZLibDataCompressor.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <string>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/complaints.h"

namespace arete::vtk {
namespace {

void set_compressor(vtkXMLWriter& writer, Compression compression) {
  switch (compression) {
    case Compression::none:
      writer.SetCompressor(nullptr);
      break;
    case Compression::lz4:
      writer.SetCompressor(vtkNew<vtkLZ4DataCompressor>());
      break;
    case Compression::zlib: {
      vtkNew<vtkZLibDataCompressor> zlib;
      zlib->SetCompressionLevel(1);
      writer.SetCompressor(zlib);
      break;
    }
  }
}

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw WriteError("cannot write '" + path.string() + "': " + why);
}

/// The stream a writer uses instead of opening a file by its name. Left to itself VTK cuts off
/// whatever follows the last letter or digit of the name ("a.vti~" would overwrite "a.vti"), and
/// closes the file without looking whether the last buffer went out.
class StreamOf : public vtkXMLWriter {
 public:
  static std::ostream*& of(vtkXMLWriter& writer) { return writer.*(&StreamOf::Stream); }
};

}  // namespace

void write_xml(vtkXMLWriter& writer, vtkDataObject& data, const std::filesystem::path& path,
               const WriteOptions& options) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  if (!file) {
    fail(path, std::string(std::strerror(errno)) +
                   "; give a path in an existing folder that you may write to");
  }
  Complaints complaints;
  complaints.watch(writer);
  complaints.watch(*writer.GetExecutive());

  writer.SetDataModeToAppended();
  writer.EncodeAppendedDataOff();
  writer.SetHeaderTypeToUInt64();
  set_compressor(writer, options.compression);
  writer.SetInputDataObject(&data);
  StreamOf::of(writer) = &file;
  const bool written = writer.Write() == 1;
  StreamOf::of(writer) = nullptr;
  file.close();
  if (!file) fail(path, "the disk is full or a size limit is reached; free some room");
  if (!written || complaints.any()) fail(path, "VTK gave up (" + complaints.first() + ")");
}

}  // namespace arete::vtk

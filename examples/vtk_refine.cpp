// SPDX-License-Identifier: MIT
// A VTK pipeline: heights from a file, refined x4, as a surface with limit normals.
//   example_vtk_refine IN.vti OUT.vtp
#include <vtkAreteRefineImage.h>
#include <vtkAreteSurface.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataWriter.h>

int main(int argc, char** argv) {
  if (argc != 3) return 2;
  vtkNew<vtkXMLImageDataReader> heights;
  heights->SetFileName(argv[1]);

  vtkNew<vtkAreteRefineImage> refine;
  refine->SetInputConnection(heights->GetOutputPort());
  refine->SetScheme("b-spline:degree=3");
  refine->SetLevels(2);

  vtkNew<vtkAreteSurface> surface;
  surface->SetInputConnection(refine->GetOutputPort());
  surface->SetScheme("b-spline:degree=3");

  vtkNew<vtkXMLPolyDataWriter> writer;
  writer->SetInputConnection(surface->GetOutputPort());
  writer->SetFileName(argv[2]);
  writer->SetDataModeToAppended();
  writer->EncodeAppendedDataOff();
  writer->SetCompressorTypeToLZ4();
  return writer->Write() == 1 ? 0 : 1;
}

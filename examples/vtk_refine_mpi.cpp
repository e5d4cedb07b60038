// SPDX-License-Identifier: MIT
// The same filter on several processes or machines: each refines its pieces of the result, one after
// the other, and writes them; nobody holds the whole.
//   mpiexec -n 4 example_vtk_refine_mpi IN.vti OUT.pvti SCHEME LEVELS [PIECES_A_RANK]
#include <vtkAreteRefineImage.h>
#include <vtkMPIController.h>
#include <vtkNew.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPImageDataWriter.h>

#include <cstdlib>

int main(int argc, char** argv) {
  vtkNew<vtkMPIController> controller;
  controller->Initialize(&argc, &argv);
  int written = 0;
  if (argc == 5 || argc == 6) {
    const int rank = controller->GetLocalProcessId();
    const int pieces = argc == 6 ? std::atoi(argv[5]) : 1;
    vtkNew<vtkXMLImageDataReader> heights;
    heights->SetFileName(argv[1]);

    vtkNew<vtkAreteRefineImage> refine;
    refine->SetInputConnection(heights->GetOutputPort());
    refine->SetScheme(argv[3]);
    refine->SetLevels(std::atoi(argv[4]));
    refine->SetNumberOfThreads(1);  // the ranks are the parallelism

    vtkNew<vtkXMLPImageDataWriter> writer;
    writer->SetInputConnection(refine->GetOutputPort());
    writer->SetFileName(argv[2]);
    writer->SetController(controller);
    writer->SetNumberOfPieces(controller->GetNumberOfProcesses() * pieces);
    writer->SetStartPiece(rank * pieces);
    writer->SetEndPiece(rank * pieces + pieces - 1);
    writer->SetWriteSummaryFile(1);  // on every rank: the writer gathers from all of them
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetCompressorTypeToNone();
    writer->SetHeaderTypeToUInt64();
    written = writer->Write();
  }
  controller->Finalize();
  return written == 1 ? 0 : 1;
}

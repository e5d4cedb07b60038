// SPDX-License-Identifier: MIT
#include "internal/structured_request.h"

#include "vtkExtentTranslator.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerRequestKey.h"
#include "vtkNew.h"
#include "vtkStreamingDemandDrivenPipeline.h"

namespace arete::vtk_filters {
namespace {

using Pipeline = vtkStreamingDemandDrivenPipeline;

constexpr VtkExtent nothing{0, -1, 0, -1, 0, -1};

VtkExtent piece_of(const VtkExtent& whole, int piece, int pieces, int ghosts, int mode) {
  if (is_empty(whole) || piece >= pieces) return nothing;
  VtkExtent from = whole;
  VtkExtent part = nothing;
  const vtkNew<vtkExtentTranslator> translator;
  if (translator->PieceToExtentThreadSafe(piece, pieces, ghosts, from.data(), part.data(), mode,
                                          0) == 0)
    return nothing;
  return is_empty(part) ? nothing : part;
}

}  // namespace

VtkExtent whole_extent(vtkInformation* info) {
  VtkExtent extent = nothing;
  if (info->Has(Pipeline::WHOLE_EXTENT())) info->Get(Pipeline::WHOLE_EXTENT(), extent.data());
  return extent;
}

VtkExtent requested_extent(vtkInformation* out, const VtkExtent& whole) {
  const int pieces = Pipeline::GetUpdateNumberOfPieces(out);
  if (pieces > 1) {
    int mode = vtkExtentTranslator::BLOCK_MODE;
    if (out->Has(vtkExtentTranslator::UPDATE_SPLIT_MODE()))
      mode = out->Get(vtkExtentTranslator::UPDATE_SPLIT_MODE());
    return piece_of(whole, Pipeline::GetUpdatePiece(out), pieces,
                    Pipeline::GetUpdateGhostLevel(out), mode);
  }
  VtkExtent extent = nothing;
  Pipeline::GetUpdateExtent(out, extent.data());
  return is_empty(extent) ? nothing : extent;
}

VtkExtent requested_part(vtkInformation* out, const VtkExtent& whole) {
  const int pieces = std::max(Pipeline::GetUpdateNumberOfPieces(out), 1);
  return piece_of(whole, std::max(Pipeline::GetUpdatePiece(out), 0), pieces, 0,
                  vtkExtentTranslator::BLOCK_MODE);
}

void request_extent(vtkInformation* in, const VtkExtent& extent) {
  VtkExtent wanted = extent;
  in->Set(Pipeline::UPDATE_EXTENT(), wanted.data(), 6);
  in->Set(Pipeline::UPDATE_PIECE_NUMBER(), 0);
  in->Set(Pipeline::UPDATE_NUMBER_OF_PIECES(), 1);
  in->Set(Pipeline::UPDATE_NUMBER_OF_GHOST_LEVELS(), 0);
  in->Set(Pipeline::UPDATE_EXTENT_INITIALIZED(), 1);
}

}  // namespace arete::vtk_filters

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "internal/structured_piece.h"

class vtkImageData;
class vtkDataArray;

namespace arete::vtk_filters {

/// What restoring an image needs besides numbers: where it was and what its arrays are called. Kept
/// as the notes of the details, one `key values` a line, numbers as hexadecimal floats (exact).
struct ImageNotes {
  struct Array {
    int components = 1;
    std::string name;
  };

  VtkExtent extent{};
  std::array<double, 3> origin{};
  std::array<double, 3> spacing{};
  std::array<double, 9> direction{};
  bool hides = false;  ///< the image had hidden points
  std::vector<Array> arrays;

  [[nodiscard]] static ImageNotes of(vtkImageData* image, const std::vector<vtkDataArray*>& arrays);
  [[nodiscard]] std::string text() const;
  /// \throws InvalidDetails if the text is not of this kind.
  [[nodiscard]] static ImageNotes parse(const std::string& text);

  [[nodiscard]] int bands() const;
  void place(vtkImageData* image) const;
};

}  // namespace arete::vtk_filters

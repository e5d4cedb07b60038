// SPDX-License-Identifier: MIT
#include "internal/image_notes.h"

#include <cstdlib>
#include <sstream>

#include "arete/reverse/error.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix3x3.h"

namespace arete::vtk_filters {
namespace {

template <class Numbers>
void write(std::ostream& out, const char* key, const Numbers& numbers) {
  out << key << std::hexfloat;
  for (const auto number : numbers) out << ' ' << number;
  out << std::defaultfloat << '\n';
}

// Streams do not read hexadecimal floats.
template <class Numbers>
bool read(std::istream& in, Numbers& numbers) {
  for (auto& number : numbers) {
    std::string word;
    if (!(in >> word)) return false;
    char* end = nullptr;
    number = static_cast<typename Numbers::value_type>(std::strtod(word.c_str(), &end));
    if (end == word.c_str() || *end != 0) return false;
  }
  return true;
}

}  // namespace

ImageNotes ImageNotes::of(vtkImageData* image, const std::vector<vtkDataArray*>& arrays) {
  ImageNotes notes;
  image->GetExtent(notes.extent.data());
  image->GetOrigin(notes.origin.data());
  image->GetSpacing(notes.spacing.data());
  std::copy_n(image->GetDirectionMatrix()->GetData(), 9, notes.direction.begin());
  notes.hides = image->GetPointGhostArray() != nullptr;
  for (vtkDataArray* array : arrays)
    notes.arrays.push_back(
        {array->GetNumberOfComponents(), array->GetName() ? array->GetName() : ""});
  return notes;
}

std::string ImageNotes::text() const {
  std::ostringstream out;
  out << "image\n";
  write(out, "extent", extent);
  write(out, "origin", origin);
  write(out, "spacing", spacing);
  write(out, "direction", direction);
  if (hides) out << "hides\n";
  for (const Array& array : arrays) {
    std::string name = array.name;
    for (char& c : name)
      if (c == '\n') c = ' ';
    out << "array " << array.components << ' ' << name << '\n';
  }
  return out.str();
}

ImageNotes ImageNotes::parse(const std::string& text) {
  ImageNotes notes;
  std::istringstream lines(text);
  std::string line;
  bool good = std::getline(lines, line) && line == "image";
  int places = 0;
  while (good && std::getline(lines, line)) {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "extent" && ++places)
      good = read(words, notes.extent);
    else if (key == "origin" && ++places)
      good = read(words, notes.origin);
    else if (key == "spacing" && ++places)
      good = read(words, notes.spacing);
    else if (key == "direction" && ++places)
      good = read(words, notes.direction);
    else if (key == "hides")
      notes.hides = true;
    else if (key == "array") {
      Array& array = notes.arrays.emplace_back();
      good = static_cast<bool>(words >> array.components) && array.components > 0;
      words.get();
      std::getline(words, array.name);
    }
  }
  if (!good || places != 4)
    throw InvalidDetails("these details were not written by vtkAreteCoarsen; use arete restore");
  return notes;
}

int ImageNotes::bands() const {
  int count = 0;
  for (const Array& array : arrays) count += array.components;
  return count;
}

void ImageNotes::place(vtkImageData* image) const {
  image->SetExtent(const_cast<int*>(extent.data()));
  image->SetOrigin(origin.data());
  image->SetSpacing(spacing.data());
  image->SetDirectionMatrix(direction.data());
}

}  // namespace arete::vtk_filters

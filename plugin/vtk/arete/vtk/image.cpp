// SPDX-License-Identifier: MIT
#include "arete/vtk/image.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include "arete/vtk/error.h"

namespace arete::vtk {
namespace {

double to_linear(double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); }
double to_srgb(double v) {
  return v <= 0.0031308 ? v * 12.92 : 1.055 * std::pow(v, 1 / 2.4) - 0.055;
}

constexpr int linear_steps = 4095;

/// 8 bits to 12 bits of linear light and back, by table: pow for every pixel takes seconds.
struct LightTables {
  std::array<int, 256> linear{};
  std::array<std::uint8_t, linear_steps + 1> coded{};

  LightTables() {
    for (std::size_t i = 0; i < linear.size(); ++i) {
      linear[i] =
          static_cast<int>(std::lround(to_linear(static_cast<double>(i) / 255) * linear_steps));
    }
    for (std::size_t i = 0; i < coded.size(); ++i) {
      coded[i] = static_cast<std::uint8_t>(
          std::lround(to_srgb(static_cast<double>(i) / linear_steps) * 255));
    }
  }
};

}  // namespace

Image shrink(const Image& image, int factor) {
  static const LightTables tables;
  Image small{image.width / factor, image.height / factor, {}};
  small.pixels.resize(static_cast<std::size_t>(small.width) *
                      static_cast<std::size_t>(small.height));
  const int area = factor * factor;
  auto out = small.pixels.begin();
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x, ++out) {
      std::array<int, 3> sum{};
      for (int k = 0; k < area; ++k) {
        const Rgb& pixel = image(x * factor + k % factor, y * factor + k / factor);
        for (std::size_t c = 0; c < 3; ++c) sum[c] += tables.linear[pixel[c]];
      }
      for (std::size_t c = 0; c < 3; ++c) {
        (*out)[c] = tables.coded[static_cast<std::size_t>((sum[c] + area / 2) / area)];
      }
    }
  }
  return small;
}

void write_png(const Image& image, const std::filesystem::path& path) {
  const auto fail = [&](const std::string& why) {
    throw WriteError("cannot write '" + path.string() + "': " + why);
  };
  const auto size = static_cast<std::size_t>(std::max(image.width, 0)) *
                    static_cast<std::size_t>(std::max(image.height, 0));
  if (size == 0 || image.pixels.size() != size) fail("the picture is empty or incomplete");

  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto row_bytes = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y) {  // VTK's first row is the lowest
    std::memcpy(data->GetScalarPointer(0, image.height - 1 - y, 0), image(0, y).data(), row_bytes);
  }
  // Into memory first: the writer would print what goes wrong with a file, and miss a full disk.
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(data);
  writer->Write();
  vtkUnsignedCharArray* png = writer->GetResult();
  if (png == nullptr) fail("VTK gave up");

  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(png->GetPointer(0)), png->GetNumberOfValues());
  file.close();
  if (!file)
    fail(std::string(std::strerror(errno)) + "; see to the folder and the room on the disk");
}

}  // namespace arete::vtk

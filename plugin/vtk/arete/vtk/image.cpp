// SPDX-License-Identifier: MIT
#include "arete/vtk/image.h"

#include <vtkImageData.h>
#include <vtkJPEGWriter.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <cstring>
#include <fstream>
#include <string>

#include "arete/vtk/error.h"
#include "arete/vtk/internal/vtk_image.h"

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

vtkNew<vtkImageData> to_vtk(const Image& image) {
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const auto row_bytes = static_cast<std::size_t>(image.width) * 3;
  for (int y = 0; y < image.height; ++y)
    std::memcpy(data->GetScalarPointer(0, image.height - 1 - y, 0), image(0, y).data(), row_bytes);
  return data;
}

namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& why) {
  throw WriteError("cannot write '" + path.string() + "': " + why);
}

/// Into memory: a VTK writer would print what goes wrong with a file, and miss a full disk.
template <class Writer>
std::vector<std::uint8_t> encode(const Image& image, const std::filesystem::path& path,
                                 Writer& writer) {
  const auto size = static_cast<std::size_t>(std::max(image.width, 0)) *
                    static_cast<std::size_t>(std::max(image.height, 0));
  if (size == 0 || image.pixels.size() != size) fail(path, "the picture is empty or incomplete");
  const auto data = to_vtk(image);
  writer.WriteToMemoryOn();
  writer.SetInputData(data);
  writer.Write();
  vtkUnsignedCharArray* bytes = writer.GetResult();
  if (bytes == nullptr) fail(path, "VTK gave up");
  return {bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues()};
}

void write_bytes(const std::vector<std::uint8_t>& bytes, const std::filesystem::path& path) {
  errno = 0;
  std::ofstream file(path, std::ios::binary);
  file.write(reinterpret_cast<const char*>(bytes.data()),
             static_cast<std::streamsize>(bytes.size()));
  file.close();
  if (!file)
    fail(path, std::string(std::strerror(errno)) + "; see to the folder and the room on the disk");
}

bool is_jpeg(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension == ".jpg" || extension == ".jpeg";
}

}  // namespace

std::vector<std::uint8_t> encode_png(const Image& image, const std::filesystem::path& path) {
  vtkNew<vtkPNGWriter> writer;
  return encode(image, path, *writer);
}

void write_png(const Image& image, const std::filesystem::path& path) {
  write_bytes(encode_png(image, path), path);
}

void write_picture(const Image& image, const std::filesystem::path& path) {
  if (!is_jpeg(path)) return write_png(image, path);
  vtkNew<vtkJPEGWriter> writer;
  writer->SetQuality(92);
  write_bytes(encode(image, path, *writer), path);
}

}  // namespace arete::vtk

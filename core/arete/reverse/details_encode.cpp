// SPDX-License-Identifier: MIT
#include <array>

#include "arete/reverse/byte_stream.h"
#include "arete/reverse/details_file.h"
#include "arete/reverse/details_layout.h"

namespace arete {
namespace {

void put_block(Bytes& out, const Bytes& block, const Pack& pack) {
  Bytes packed;
  if (pack) packed = pack(block);
  const bool smaller = pack && packed.size() < block.size();
  const Bytes& stored = smaller ? packed : block;
  out.push_back(smaller ? details::packed : details::stored);
  put_integer(out, block.size(), 8);
  put_integer(out, stored.size(), 8);
  out.insert(out.end(), stored.begin(), stored.end());
}

Bytes bits_of(const ValidSamples& valid) {
  Bytes bits((valid.size() + 7) / 8, 0);
  for (std::size_t i = 0; i < valid.size(); ++i)
    if (valid[i] != 0) bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | (1U << (i % 8)));
  return bits;
}

std::string header_of(const DetailsFile& file) {
  std::string text = "arete details\n";
  const auto line = [&](const char* key, const std::string& value) {
    text += std::string(key) + "=" + value + "\n";
  };
  line("scheme", file.scheme);
  line("mode", std::string(to_string(file.mode)));
  line("boundary_x", std::string(to_string(file.boundaries.x)));
  line("boundary_y", std::string(to_string(file.boundaries.y)));
  line("levels", std::to_string(file.levels));
  line("rows", std::to_string(file.fine.rows));
  line("cols", std::to_string(file.fine.cols));
  line("lossy", file.lossy ? "1" : "0");
  line("bands", std::to_string(file.bands.size()));
  for (const BandDetails& band : file.bands)
    line("band", std::string(band.valid.empty() ? "complete" : "holes") + " " +
                     std::to_string(band.hidden.size()) + " " +
                     std::to_string(band.coarse_checksum));
  line("notes", std::to_string(file.notes.size()));
  return text + file.notes;
}

}  // namespace

Bytes encode_details(const DetailsFile& file, const Pack& pack) {
  Bytes out(details::magic.begin(), details::magic.end());
  const std::string header = header_of(file);
  put_integer(out, details::version, 4);
  put_integer(out, header.size(), 4);
  put_integer(out, 0, 8);  // the length, known at the end
  out.insert(out.end(), header.begin(), header.end());
  const int width = file.lossy ? 4 : 8;
  for (const BandDetails& band : file.bands) {
    if (!band.valid.empty()) put_block(out, bits_of(band.valid), pack);
    put_block(out, to_planes(band.hidden, 8), pack);
  }
  for (int level = file.levels - 1; level >= 0; --level)
    for (const BandDetails& band : file.bands)
      for (const Grid<double>* block : band.details.at(static_cast<std::size_t>(level)).blocks())
        put_block(out, to_planes(block->samples(), width), pack);
  Bytes length;
  put_integer(length, out.size() + 4, 8);
  std::copy(length.begin(), length.end(), out.begin() + details::length_place);
  put_integer(out, checksum(out), 4);
  return out;
}

std::uint32_t checksum(std::span<const std::uint8_t> bytes) {
  static const auto table = [] {
    std::array<std::uint32_t, 256> entries{};
    for (std::uint32_t i = 0; i < 256; ++i) {
      std::uint32_t value = i;
      for (int bit = 0; bit < 8; ++bit)
        value = (value & 1U) != 0 ? 0xEDB88320U ^ (value >> 1) : value >> 1;
      entries[i] = value;
    }
    return entries;
  }();
  std::uint32_t crc = 0xFFFFFFFFU;
  for (const std::uint8_t byte : bytes) crc = table[(crc ^ byte) & 0xFFU] ^ (crc >> 8);
  return crc ^ 0xFFFFFFFFU;
}

std::uint32_t checksum(const std::vector<double>& samples) {
  return checksum(std::span<const std::uint8_t>(to_planes(samples, 8)));
}

}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/reverse/byte_stream.h"
#include "arete/reverse/details_file.h"

namespace arete {
namespace {

Bytes bits_of(const ValidSamples& valid) {
  Bytes bits((valid.size() + 7) / 8, 0);
  for (std::size_t i = 0; i < valid.size(); ++i)
    if (valid[i] != 0) bits[i / 8] = static_cast<std::uint8_t>(bits[i / 8] | (1U << (i % 8)));
  return bits;
}

}  // namespace

Bytes encode_details(const DetailsFile& file, const Pack& pack) {
  details::Writer out(details::raster_kind, pack);
  out.line("scheme", file.scheme);
  out.line("mode", to_string(file.mode));
  out.line("boundary_x", to_string(file.boundaries.x));
  out.line("boundary_y", to_string(file.boundaries.y));
  out.line("levels", file.levels);
  out.line("rows", file.fine.rows);
  out.line("cols", file.fine.cols);
  out.line("lossy", file.lossy ? 1 : 0);
  out.line("bands", static_cast<Index>(file.bands.size()));
  for (const BandDetails& band : file.bands)
    out.line("band", std::string(band.valid.empty() ? "complete" : "holes") + " " +
                         std::to_string(band.hidden.size()) + " " +
                         std::to_string(band.coarse_checksum));
  out.notes(file.notes);
  const int width = file.lossy ? 4 : 8;
  for (const BandDetails& band : file.bands) {
    if (!band.valid.empty()) out.block(bits_of(band.valid));
    out.block(to_planes(band.hidden, 8));
  }
  for (int level = file.levels - 1; level >= 0; --level)
    for (const BandDetails& band : file.bands)
      for (const Grid<double>* block : band.details.at(static_cast<std::size_t>(level)).blocks())
        out.block(to_planes(block->samples(), width));
  return out.finished();
}

}  // namespace arete

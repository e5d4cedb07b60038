// SPDX-License-Identifier: MIT
#include <algorithm>
#include <string_view>

#include "arete/reverse/byte_stream.h"
#include "arete/reverse/details_file.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

using details::damaged;
using details::Reader;

// So that sizes in bytes never overflow.
constexpr std::uint64_t largest_samples = std::uint64_t{1} << 48;

std::uint64_t samples_in(Extent extent) {
  return static_cast<std::uint64_t>(extent.rows) * static_cast<std::uint64_t>(extent.cols);
}

struct BandHead {
  bool holes = false;
  Index hidden = 0;
  std::uint32_t coarse_checksum = 0;
};

BandHead band_head(std::string_view text, std::uint64_t coarse_samples) {
  BandHead band;
  const auto first = text.find(' ');
  const auto second = first == std::string_view::npos ? first : text.find(' ', first + 1);
  if (second == std::string_view::npos) damaged("a band in the header");
  const std::string_view kind = text.substr(0, first);
  if (kind != "holes" && kind != "complete") damaged("a band in the header");
  band.holes = kind == "holes";
  band.hidden = Reader::to_number(text.substr(first + 1, second - first - 1), "a band", 0,
                                  static_cast<Index>(coarse_samples));
  band.coarse_checksum = static_cast<std::uint32_t>(
      Reader::to_number(text.substr(second + 1), "a band", 0, 0xFFFFFFFFLL));
  return band;
}

ValidSamples valid_from(const Bytes& bits, std::uint64_t count) {
  ValidSamples valid(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < valid.size(); ++i)
    valid[i] = static_cast<std::uint8_t>((bits[i / 8] >> (i % 8)) & 1U);
  return valid;
}

DetailsFile decode_checked(Reader& in) {
  constexpr Index largest = (Index{1} << 31) - 1;
  DetailsFile file;
  file.scheme = in.text("scheme");
  file.mode = parse_reverse_mode(in.text("mode"));
  file.boundaries.x = parse_boundary(in.text("boundary_x"));
  file.boundaries.y = parse_boundary(in.text("boundary_y"));
  file.levels = static_cast<int>(in.number("levels", 0, 64));
  file.fine.rows = in.number("rows", 1, largest);
  file.fine.cols = in.number("cols", 1, largest);
  if (samples_in(file.fine) > largest_samples) damaged("rows and cols in the header");
  file.lossy = in.number("lossy", 0, 1) == 1;
  const Mask mask = parse_scheme(file.scheme).mask();
  const GridPyramid pyramid(mask, file.fine, file.options());
  const Index bands = in.number("bands", 1, 65535);
  std::vector<BandHead> heads;
  for (Index i = 0; i < bands; ++i)
    heads.push_back(band_head(in.text("band"), samples_in(pyramid.extent(file.levels))));
  file.notes = in.notes();

  for (const BandHead& head : heads) {
    BandDetails band;
    band.coarse_checksum = head.coarse_checksum;
    const std::uint64_t count = samples_in(file.fine);
    if (head.holes) band.valid = valid_from(in.block((count + 7) / 8), count);
    const ValidSamples coarse_valid = coarsened(band.valid, pyramid, file.levels);
    if (std::count(coarse_valid.begin(), coarse_valid.end(), 0) != head.hidden)
      damaged("the missing coarse samples are not as many as the header says");
    band.hidden = from_planes(in.block(8 * static_cast<std::uint64_t>(head.hidden)), 8);
    band.details.resize(static_cast<std::size_t>(file.levels));
    file.bands.push_back(std::move(band));
  }
  const int width = file.lossy ? 4 : 8;
  for (int level = file.levels - 1; level >= 0; --level)
    for (BandDetails& band : file.bands) {
      const ReverseLevel& y = pyramid.rows(level);
      const ReverseLevel& x = pyramid.cols(level);
      auto& parts = band.details[static_cast<std::size_t>(level)];
      const auto read = [&](Grid<double>& block, Extent extent) {
        const Bytes bytes = in.block(samples_in(extent) * static_cast<std::uint64_t>(width));
        block = Grid<double>({extent.rows, extent.cols});
        block.samples() = from_planes(bytes, width);
      };
      read(parts.cd, {y.coarse_count, x.detail_count()});
      read(parts.dc, {y.detail_count(), x.coarse_count});
      read(parts.dd, {y.detail_count(), x.detail_count()});
    }
  in.end();
  return file;
}

}  // namespace

DetailsFile decode_details(std::span<const std::uint8_t> bytes, const Unpack& unpack) {
  Reader in(bytes, unpack);
  if (in.kind() == details::mesh_kind)
    throw InvalidDetails("these are the details of a mesh, not of a raster; restore a mesh");
  if (in.kind() != details::raster_kind) damaged("the header does not begin as one");
  try {
    return decode_checked(in);
  } catch (const InvalidField& error) {
    damaged(error.what());
  } catch (const InvalidScheme& error) {
    damaged(error.what());
  }
}

}  // namespace arete

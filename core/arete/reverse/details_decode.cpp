// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <string_view>

#include "arete/reverse/byte_stream.h"
#include "arete/reverse/details_file.h"
#include "arete/reverse/details_layout.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

using View = std::span<const std::uint8_t>;

[[noreturn]] void damaged(const std::string& where) {
  throw InvalidDetails("the details are damaged (" + where +
                       "); make them again with 'arete coarsen'");
}

// Lines of key=value in the order in which they were written.
class Header {
 public:
  explicit Header(std::string_view text) : rest_(text) {
    if (next_line() != "arete details") damaged("the header does not begin as one");
  }

  std::string_view text(std::string_view key) {
    const std::string_view line = next_line();
    if (line.size() <= key.size() || line.substr(0, key.size()) != key || line[key.size()] != '=')
      damaged("the header has no " + std::string(key));
    return line.substr(key.size() + 1);
  }
  Index number(std::string_view key, Index lowest, Index highest) {
    return to_number(text(key), key, lowest, highest);
  }
  static Index to_number(std::string_view text, std::string_view key, Index lowest, Index highest) {
    Index value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size() || value < lowest ||
        value > highest)
      damaged(std::string(key) + " in the header is not a possible number");
    return value;
  }
  [[nodiscard]] std::string_view rest() const { return rest_; }

 private:
  std::string_view next_line() {
    const auto end = rest_.find('\n');
    if (end == std::string_view::npos) damaged("the header is cut off");
    const std::string_view line = rest_.substr(0, end);
    rest_.remove_prefix(end + 1);
    return line;
  }

  std::string_view rest_;
};

class Blocks {
 public:
  Blocks(View bytes, const Unpack& unpack) : bytes_(bytes), unpack_(unpack) {}

  // The next block, which must have this size. Nothing is allocated before that is known.
  Bytes next(std::uint64_t wanted) {
    constexpr std::uint64_t head = 17;
    if (bytes_.size() < head) damaged("a block is missing");
    const std::uint8_t method = bytes_[0];
    const std::uint64_t size = get_integer(bytes_.subspan(1), 8);
    const std::uint64_t stored = get_integer(bytes_.subspan(9), 8);
    bytes_ = bytes_.subspan(head);
    if (size != wanted) damaged("a block has another size than the header says");
    if (stored > bytes_.size()) damaged("a block is cut off");
    const View content = bytes_.first(static_cast<std::size_t>(stored));
    bytes_ = bytes_.subspan(static_cast<std::size_t>(stored));
    if (method == details::stored) {
      if (stored != size) damaged("a block has another size than it says");
      return {content.begin(), content.end()};
    }
    if (method != details::packed) damaged("a block is packed in an unknown way");
    if (!unpack_)
      throw InvalidDetails(
          "the details are compressed and this program was built without zlib; "
          "use one that has it");
    // Deflate never shrinks bytes more than 1032 times.
    if (size / 1100 > stored) damaged("a block says it is longer than it can be");
    Bytes unpacked = unpack_(content, static_cast<std::size_t>(size));
    if (unpacked.size() != size) damaged("a block cannot be unpacked");
    return unpacked;
  }
  [[nodiscard]] bool empty() const { return bytes_.empty(); }

 private:
  View bytes_;
  const Unpack& unpack_;
};

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
  band.hidden = Header::to_number(text.substr(first + 1, second - first - 1), "a band", 0,
                                  static_cast<Index>(coarse_samples));
  band.coarse_checksum = static_cast<std::uint32_t>(
      Header::to_number(text.substr(second + 1), "a band", 0, 0xFFFFFFFFLL));
  return band;
}

ValidSamples valid_from(const Bytes& bits, std::uint64_t count) {
  ValidSamples valid(static_cast<std::size_t>(count));
  for (std::size_t i = 0; i < valid.size(); ++i)
    valid[i] = static_cast<std::uint8_t>((bits[i / 8] >> (i % 8)) & 1U);
  return valid;
}

View checked(View bytes) {
  const auto same = [&](std::size_t count) {
    return bytes.size() >= count &&
           std::equal(details::magic.begin(),
                      details::magic.begin() + static_cast<std::ptrdiff_t>(count), bytes.begin());
  };
  if (!same(details::magic.size())) {
    if (bytes.size() < details::magic.size() && same(bytes.size()) && !bytes.empty())
      damaged("the file is cut off");
    throw InvalidDetails(
        "this is not a details file of arete; give the file that 'arete coarsen "
        "--details' wrote");
  }
  if (bytes.size() < details::prologue + 4) damaged("the file is cut off");
  const std::uint64_t version = get_integer(bytes.subspan(8), 4);
  if (version > details::version)
    throw InvalidDetails("the details were written by a newer arete (details version " +
                         std::to_string(version) + ", this one reads up to " +
                         std::to_string(details::version) + "); use the newer program");
  if (version == 0) damaged("version 0");
  const std::uint64_t length = get_integer(bytes.subspan(details::length_place), 8);
  if (length > bytes.size()) damaged("the file is cut off");
  if (length < bytes.size()) damaged("something follows the end of the file");
  const View content = bytes.first(bytes.size() - 4);
  if (checksum(content) != get_integer(bytes.last(4), 4)) damaged("the checksum is wrong");
  return content;
}

DetailsFile decode_checked(View content, const Unpack& unpack) {
  const std::uint64_t header_size = get_integer(content.subspan(12), 4);
  if (header_size > content.size() - details::prologue) damaged("the header is cut off");
  const View header_bytes =
      content.subspan(details::prologue, static_cast<std::size_t>(header_size));
  Header header(
      std::string_view(reinterpret_cast<const char*>(header_bytes.data()), header_bytes.size()));
  constexpr Index largest = (Index{1} << 31) - 1;
  DetailsFile file;
  file.scheme = header.text("scheme");
  file.mode = parse_reverse_mode(header.text("mode"));
  file.boundaries.x = parse_boundary(header.text("boundary_x"));
  file.boundaries.y = parse_boundary(header.text("boundary_y"));
  file.levels = static_cast<int>(header.number("levels", 0, 64));
  file.fine.rows = header.number("rows", 1, largest);
  file.fine.cols = header.number("cols", 1, largest);
  if (samples_in(file.fine) > largest_samples) damaged("rows and cols in the header");
  file.lossy = header.number("lossy", 0, 1) == 1;
  const Mask mask = parse_scheme(file.scheme).mask();
  const GridPyramid pyramid(mask, file.fine, file.options());
  const Index bands = header.number("bands", 1, 65535);
  std::vector<BandHead> heads;
  for (Index i = 0; i < bands; ++i)
    heads.push_back(band_head(header.text("band"), samples_in(pyramid.extent(file.levels))));
  const Index notes = header.number("notes", 0, largest);
  if (header.rest().size() != static_cast<std::size_t>(notes)) damaged("notes in the header");
  file.notes = header.rest();

  Blocks blocks(content.subspan(details::prologue + static_cast<std::size_t>(header_size)), unpack);
  for (const BandHead& head : heads) {
    BandDetails band;
    band.coarse_checksum = head.coarse_checksum;
    const std::uint64_t count = samples_in(file.fine);
    if (head.holes) band.valid = valid_from(blocks.next((count + 7) / 8), count);
    const ValidSamples coarse_valid = coarsened(band.valid, pyramid, file.levels);
    if (std::count(coarse_valid.begin(), coarse_valid.end(), 0) != head.hidden)
      damaged("the missing coarse samples are not as many as the header says");
    band.hidden = from_planes(blocks.next(8 * static_cast<std::uint64_t>(head.hidden)), 8);
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
        const Bytes bytes = blocks.next(samples_in(extent) * static_cast<std::uint64_t>(width));
        block = Grid<double>({extent.rows, extent.cols});
        block.samples() = from_planes(bytes, width);
      };
      read(parts.cd, {y.coarse_count, x.detail_count()});
      read(parts.dc, {y.detail_count(), x.coarse_count});
      read(parts.dd, {y.detail_count(), x.detail_count()});
    }
  if (!blocks.empty()) damaged("something follows the last block");
  return file;
}

}  // namespace

DetailsFile decode_details(std::span<const std::uint8_t> bytes, const Unpack& unpack) {
  const View content = checked(bytes);
  try {
    return decode_checked(content, unpack);
  } catch (const InvalidField& error) {
    damaged(error.what());
  } catch (const InvalidScheme& error) {
    damaged(error.what());
  }
}

}  // namespace arete

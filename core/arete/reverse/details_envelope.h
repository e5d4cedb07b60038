// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "arete/field/grid.h"
#include "arete/reverse/error.h"

namespace arete {

using Bytes = std::vector<std::uint8_t>;

/// Packs bytes, or unpacks them to `size` bytes (throwing or returning another size when they are
/// damaged). Core has no compression of its own; the caller may bring one.
using Pack = std::function<Bytes(std::span<const std::uint8_t>)>;
using Unpack = std::function<Bytes(std::span<const std::uint8_t>, std::size_t size)>;

/// CRC-32 (IEEE 802.3, as zlib's and PNG's).
[[nodiscard]] std::uint32_t checksum(std::span<const std::uint8_t> bytes);
/// Of the bytes of the samples, little-endian doubles.
[[nodiscard]] std::uint32_t checksum(const std::vector<double>& samples);

namespace details {

/// What the details files of rasters and of meshes have in common: magic, version, lengths, a
/// header of lines, blocks, a checksum (the layout is in details_file.h).
class Writer {
 public:
  /// `kind`: the header's first line. `pack` empty: blocks are stored.
  Writer(std::string_view kind, const Pack& pack) : pack_(pack), header_(kind) { header_ += '\n'; }

  void line(std::string_view key, std::string_view value);
  void line(std::string_view key, Index value) { line(key, std::to_string(value)); }
  /// Text that ends the header; its length is written as a line.
  void notes(const std::string& text);
  void block(const Bytes& bytes);
  [[nodiscard]] Bytes finished() const;

 private:
  const Pack& pack_;
  std::string header_;
  Bytes blocks_;
};

/// Reads what Writer wrote, in the same order; every step throws InvalidDetails for bytes that do
/// not go on as they must.
class Reader {
 public:
  /// Checks magic, version, lengths and checksum. The bytes and `unpack` must outlive this.
  Reader(std::span<const std::uint8_t> bytes, const Unpack& unpack);

  /// The header's first line.
  [[nodiscard]] const std::string& kind() const { return kind_; }
  [[nodiscard]] std::string_view text(std::string_view key);
  [[nodiscard]] Index number(std::string_view key, Index lowest, Index highest) {
    return to_number(text(key), key, lowest, highest);
  }
  [[nodiscard]] static Index to_number(std::string_view text, std::string_view key, Index lowest,
                                       Index highest);
  /// The numbers of a line, separated by blanks.
  [[nodiscard]] static std::vector<Index> to_numbers(std::string_view text, std::string_view key,
                                                     std::size_t count, Index highest);
  /// What ends the header.
  [[nodiscard]] std::string notes();
  /// The next block, which must have this size. Nothing is allocated before that is known.
  [[nodiscard]] Bytes block(std::uint64_t wanted);
  /// \throws InvalidDetails if blocks are left.
  void end() const;

 private:
  std::string_view next_line();

  const Unpack& unpack_;
  std::span<const std::uint8_t> blocks_;
  std::string_view header_;
  std::string kind_;
};

/// The first lines of the two kinds.
constexpr std::string_view raster_kind = "arete details";
constexpr std::string_view mesh_kind = "arete mesh details";

/// \throws InvalidDetails that says where they are damaged.
[[noreturn]] void damaged(const std::string& where);

}  // namespace details
}  // namespace arete

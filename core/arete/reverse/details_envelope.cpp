// SPDX-License-Identifier: MIT
#include "arete/reverse/details_envelope.h"

#include <algorithm>
#include <array>
#include <charconv>

#include "arete/reverse/byte_stream.h"

namespace arete {

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

namespace details {
namespace {

constexpr std::array<std::uint8_t, 8> magic{0x89, 'A', 'R', 'D', 0x0D, 0x0A, 0x1A, 0x0A};
constexpr std::uint32_t version_now = 1;
constexpr std::size_t prologue = 24;  // magic, version, header length, file length
constexpr std::uint8_t stored = 0;
constexpr std::uint8_t packed = 1;

using View = std::span<const std::uint8_t>;

View checked(View bytes) {
  const auto same = [&](std::size_t count) {
    return bytes.size() >= count &&
           std::equal(magic.begin(), magic.begin() + static_cast<std::ptrdiff_t>(count),
                      bytes.begin());
  };
  if (!same(magic.size())) {
    if (bytes.size() < magic.size() && same(bytes.size()) && !bytes.empty())
      damaged("the file is cut off");
    throw InvalidDetails(
        "this is not a details file of arete; give the file that 'arete coarsen "
        "--details' wrote");
  }
  if (bytes.size() < prologue + 4) damaged("the file is cut off");
  const std::uint64_t version = get_integer(bytes.subspan(8), 4);
  if (version > version_now)
    throw InvalidDetails("the details were written by a newer arete (details version " +
                         std::to_string(version) + ", this one reads up to " +
                         std::to_string(version_now) + "); use the newer program");
  if (version == 0) damaged("version 0");
  const std::uint64_t length = get_integer(bytes.subspan(16), 8);
  if (length > bytes.size()) damaged("the file is cut off");
  if (length < bytes.size()) damaged("something follows the end of the file");
  const View content = bytes.first(bytes.size() - 4);
  if (checksum(content) != get_integer(bytes.last(4), 4)) damaged("the checksum is wrong");
  return content;
}

}  // namespace

void damaged(const std::string& where) {
  throw InvalidDetails("the details are damaged (" + where +
                       "); make them again with 'arete coarsen'");
}

void Writer::line(std::string_view key, std::string_view value) {
  header_.append(key).append("=").append(value).append("\n");
}

void Writer::notes(const std::string& text) {
  line("notes", static_cast<Index>(text.size()));
  header_ += text;
}

void Writer::block(const Bytes& bytes) {
  Bytes smaller;
  if (pack_) smaller = pack_(bytes);
  const bool pays = pack_ && smaller.size() < bytes.size();
  const Bytes& kept = pays ? smaller : bytes;
  blocks_.push_back(pays ? packed : stored);
  put_integer(blocks_, bytes.size(), 8);
  put_integer(blocks_, kept.size(), 8);
  blocks_.insert(blocks_.end(), kept.begin(), kept.end());
}

Bytes Writer::finished() const {
  Bytes out(magic.begin(), magic.end());
  put_integer(out, version_now, 4);
  put_integer(out, header_.size(), 4);
  put_integer(out, prologue + header_.size() + blocks_.size() + 4, 8);
  out.insert(out.end(), header_.begin(), header_.end());
  out.insert(out.end(), blocks_.begin(), blocks_.end());
  put_integer(out, checksum(out), 4);
  return out;
}

Reader::Reader(View bytes, const Unpack& unpack) : unpack_(unpack) {
  const View content = checked(bytes);
  const std::uint64_t size = get_integer(content.subspan(12), 4);
  if (size > content.size() - prologue) damaged("the header is cut off");
  const View header = content.subspan(prologue, static_cast<std::size_t>(size));
  header_ = {reinterpret_cast<const char*>(header.data()), header.size()};
  blocks_ = content.subspan(prologue + static_cast<std::size_t>(size));
  kind_ = next_line();
}

std::string_view Reader::next_line() {
  const auto end = header_.find('\n');
  if (end == std::string_view::npos) damaged("the header is cut off");
  const std::string_view line = header_.substr(0, end);
  header_.remove_prefix(end + 1);
  return line;
}

std::string_view Reader::text(std::string_view key) {
  const std::string_view line = next_line();
  if (line.size() <= key.size() || line.substr(0, key.size()) != key || line[key.size()] != '=')
    damaged("the header has no " + std::string(key));
  return line.substr(key.size() + 1);
}

Index Reader::to_number(std::string_view text, std::string_view key, Index lowest, Index highest) {
  Index value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < lowest || value > highest)
    damaged(std::string(key) + " in the header is not a possible number");
  return value;
}

std::vector<Index> Reader::to_numbers(std::string_view text, std::string_view key,
                                      std::size_t count, Index highest) {
  std::vector<Index> numbers;
  while (numbers.size() < count) {
    const auto blank = text.find(' ');
    if ((blank == std::string_view::npos) != (numbers.size() + 1 == count))
      damaged(std::string(key) + " in the header has not " + std::to_string(count) + " numbers");
    numbers.push_back(to_number(text.substr(0, blank), key, 0, highest));
    if (blank != std::string_view::npos) text.remove_prefix(blank + 1);
  }
  return numbers;
}

std::string Reader::notes() {
  const Index size = number("notes", 0, (Index{1} << 31) - 1);
  if (header_.size() != static_cast<std::size_t>(size)) damaged("notes in the header");
  return std::string(header_);
}

Bytes Reader::block(std::uint64_t wanted) {
  constexpr std::uint64_t head = 17;
  if (blocks_.size() < head) damaged("a block is missing");
  const std::uint8_t method = blocks_[0];
  const std::uint64_t size = get_integer(blocks_.subspan(1), 8);
  const std::uint64_t kept = get_integer(blocks_.subspan(9), 8);
  blocks_ = blocks_.subspan(head);
  if (size != wanted) damaged("a block has another size than the header says");
  if (kept > blocks_.size()) damaged("a block is cut off");
  const View content = blocks_.first(static_cast<std::size_t>(kept));
  blocks_ = blocks_.subspan(static_cast<std::size_t>(kept));
  if (method == stored) {
    if (kept != size) damaged("a block has another size than it says");
    return {content.begin(), content.end()};
  }
  if (method != packed) damaged("a block is packed in an unknown way");
  if (!unpack_)
    throw InvalidDetails(
        "the details are compressed and this program was built without zlib; "
        "use one that has it");
  // Deflate never shrinks bytes more than 1032 times.
  if (size / 1100 > kept) damaged("a block says it is longer than it can be");
  Bytes unpacked = unpack_(content, static_cast<std::size_t>(size));
  if (unpacked.size() != size) damaged("a block cannot be unpacked");
  return unpacked;
}

void Reader::end() const {
  if (!blocks_.empty()) damaged("something follows the last block");
}

}  // namespace details
}  // namespace arete

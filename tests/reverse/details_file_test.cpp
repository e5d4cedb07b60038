// SPDX-License-Identifier: MIT
// The bytes of a details file: what goes in comes out; anything else is refused, whatever it is.
#include "arete/reverse/details_file.h"

#include <gtest/gtest.h>

#include <cstring>
#include <limits>
#include <random>

#include "arete/reverse/byte_stream.h"
#include "arete/reverse/threshold.h"
#include "arete/scheme/catalogue.h"
#include "support/fields.h"

namespace arete {
namespace {

DetailsFile sample_file(bool holes, bool lossy) {
  DetailsFile file;
  file.scheme = "chaikin";
  file.mode = ReverseMode::local;
  file.boundaries = {Boundary::clamp, Boundary::extrapolate};
  file.levels = 2;
  file.fine = {11, 14};
  file.lossy = lossy;
  file.notes = "a place\nand = more";
  Grid<double> grid = test::random_heights(file.fine);
  if (holes) grid(5, 6) = grid(0, 0) = grid(10, 13) = std::numeric_limits<double>::quiet_NaN();
  BandDetails band;
  band.valid = fill_missing(grid.view());
  const Scheme scheme = parse_scheme(file.scheme);
  auto parts = decompose_grid<double>(grid.view(), scheme, file.options());
  if (lossy) drop_details(parts, 400);
  const GridPyramid pyramid(scheme.mask(), file.fine, file.options());
  const ValidSamples coarse = coarsened(band.valid, pyramid, 2);
  for (std::size_t i = 0; i < coarse.size(); ++i)
    if (coarse[i] == 0) band.hidden.push_back(parts.coarse.samples()[i]);
  band.coarse_checksum = checksum(parts.coarse.samples());
  band.details = std::move(parts.details);
  file.bands = {band, band};
  return file;
}

// A packing of its own: runs of zero bytes.
Bytes pack(std::span<const std::uint8_t> bytes) {
  Bytes out;
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    out.push_back(bytes[i]);
    if (bytes[i] != 0) continue;
    std::uint8_t run = 0;
    while (i + 1 < bytes.size() && bytes[i + 1] == 0 && run < 255) ++run, ++i;
    out.push_back(run);
  }
  return out;
}

Bytes unpack(std::span<const std::uint8_t> bytes, std::size_t size) {
  Bytes out;
  for (std::size_t i = 0; i < bytes.size() && out.size() <= size; ++i) {
    out.push_back(bytes[i]);
    if (bytes[i] == 0 && i + 1 < bytes.size()) out.insert(out.end(), bytes[++i], 0);
  }
  return out;
}

void expect_same(const DetailsFile& a, const DetailsFile& b) {
  EXPECT_EQ(a.scheme, b.scheme);
  EXPECT_EQ(a.mode, b.mode);
  EXPECT_EQ(a.boundaries, b.boundaries);
  EXPECT_EQ(a.levels, b.levels);
  EXPECT_EQ(a.fine, b.fine);
  EXPECT_EQ(a.lossy, b.lossy);
  EXPECT_EQ(a.notes, b.notes);
  ASSERT_EQ(a.bands.size(), b.bands.size());
  for (std::size_t i = 0; i < a.bands.size(); ++i) {
    EXPECT_EQ(a.bands[i].valid, b.bands[i].valid);
    EXPECT_EQ(a.bands[i].hidden, b.bands[i].hidden);
    EXPECT_EQ(a.bands[i].coarse_checksum, b.bands[i].coarse_checksum);
    ASSERT_EQ(a.bands[i].details.size(), b.bands[i].details.size());
    for (std::size_t level = 0; level < a.bands[i].details.size(); ++level)
      for (std::size_t k = 0; k < 3; ++k) {
        const auto* x = a.bands[i].details[level].blocks()[k];
        const auto* y = b.bands[i].details[level].blocks()[k];
        EXPECT_EQ(x->extent(), y->extent());
        EXPECT_EQ(x->samples(), y->samples());
      }
  }
}

TEST(details_file, comes_back_as_it_was) {
  for (const bool holes : {false, true})
    for (const bool lossy : {false, true}) {
      const DetailsFile file = sample_file(holes, lossy);
      expect_same(decode_details(encode_details(file)), file);
      const Bytes packed = encode_details(file, pack);
      expect_same(decode_details(packed, unpack), file);
      if (lossy) {
        EXPECT_LT(packed.size(), encode_details(file).size());
      }
    }
}

void expect_refused(const Bytes& bytes, const std::string& part) {
  try {
    (void)decode_details(bytes, unpack);
    FAIL() << "accepted; expected a refusal with '" << part << "'";
  } catch (const InvalidDetails& error) {
    EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
  }
}

Bytes with_checksum(Bytes bytes) {
  bytes.resize(bytes.size() - 4);
  put_integer(bytes, checksum(bytes), 4);
  return bytes;
}

TEST(details_file, foreign_newer_cut_and_changed_bytes_are_refused_by_name) {
  const Bytes good = encode_details(sample_file(true, true), pack);
  expect_refused({}, "not a details file");
  const std::string text = "x,y\n1,2\n3,4\n and some more text to be long enough";
  expect_refused({text.begin(), text.end()}, "not a details file");
  Bytes newer = good;
  newer[8] = 2;
  expect_refused(newer, "newer arete");
  for (const std::size_t size : {std::size_t{3}, std::size_t{8}, std::size_t{20}, std::size_t{60},
                                 good.size() / 2, good.size() - 1})
    expect_refused({good.begin(), good.begin() + static_cast<std::ptrdiff_t>(size)}, "cut off");
  Bytes longer = good;
  longer.push_back(0);
  expect_refused(longer, "follows the end");
  Bytes text_mode = good;
  text_mode.erase(text_mode.begin() + 4);
  expect_refused(text_mode, "not a details file");
  EXPECT_THROW((void)decode_details(good), InvalidDetails);  // packed, and no unpacker
}

TEST(details_file, every_single_changed_bit_is_refused) {
  const Bytes good = encode_details(sample_file(true, true), pack);
  for (std::size_t i = 0; i < good.size(); ++i)
    for (int bit = 0; bit < 8; ++bit) {
      Bytes bad = good;
      bad[i] = static_cast<std::uint8_t>(bad[i] ^ (1U << bit));
      EXPECT_THROW((void)decode_details(bad, unpack), InvalidDetails) << i << ", bit " << bit;
    }
}

TEST(details_file, changed_bytes_with_a_right_checksum_never_crash) {
  // What the checksum cannot catch must be caught by the structure, or be harmless numbers.
  std::mt19937 random(5);
  const Bytes good = encode_details(sample_file(true, false), pack);
  int refused = 0;
  for (int round = 0; round < 20000; ++round) {
    Bytes bad = good;
    const int changes = 1 + static_cast<int>(random() % 3);
    // Mostly in the header and the first blocks, where the structure is.
    for (int k = 0; k < changes; ++k) {
      const std::size_t span = random() % 4 == 0 ? bad.size() - 4 : 420;
      bad[random() % span] = static_cast<std::uint8_t>(random());
    }
    try {
      (void)decode_details(with_checksum(std::move(bad)), unpack);
    } catch (const InvalidDetails&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10000);
}

TEST(details_file, impossible_headers_are_refused_before_anything_is_allocated) {
  const Bytes good = encode_details(sample_file(false, false));
  const std::string header(reinterpret_cast<const char*>(good.data()), good.size());
  const auto with = [&](const std::string& from, const std::string& to) {
    EXPECT_EQ(from.size(), to.size());
    const auto place = header.find(from);
    EXPECT_NE(place, std::string::npos) << from;
    Bytes bad = good;
    std::memcpy(bad.data() + place, to.data(), to.size());
    return with_checksum(bad);
  };
  expect_refused(with("rows=11", "rows=99"), "size");
  expect_refused(with("rows=11", "rows=-1"), "rows");
  expect_refused(with("rows=11\ncols=14", "rows=9999999999"), "rows");
  expect_refused(with("scheme=chaikin", "scheme=chalkin"), "chalkin");
  expect_refused(with("levels=2", "levels=3"), "damaged");
  expect_refused(with("levels=2", "levels=x"), "levels");
  expect_refused(with("boundary_x=clamp", "boundary_x=clump"), "clump");
  expect_refused(with("bands=2", "bands=3"), "band");
  expect_refused(with("complete 0", "complete 7"), "missing coarse");
}

TEST(details_file, the_checksum_is_crc_32) {
  const std::string text = "123456789";
  EXPECT_EQ(checksum(Bytes(text.begin(), text.end())), 0xCBF43926U);
}

}  // namespace
}  // namespace arete

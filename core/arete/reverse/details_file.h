// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "arete/reverse/details_envelope.h"
#include "arete/reverse/missing_samples.h"

namespace arete {

/// What restores one band of a raster from its coarse samples.
struct BandDetails {
  std::vector<GridDetails<double>> details;  ///< of step 1 (the finest), 2, ...
  ValidSamples valid;                        ///< of the input; empty: all
  /// Numbers of the coarse samples that count as missing, in order; restoring needs them.
  std::vector<double> hidden;
  std::uint32_t coarse_checksum = 0;  ///< see checksum(); of the coarse samples, hidden ones too
};

/// All that a details file says.
struct DetailsFile {
  std::string scheme;  ///< text form
  ReverseMode mode = ReverseMode::least_squares;
  Boundaries boundaries;
  int levels = 0;
  Extent fine;         ///< of the input
  bool lossy = false;  ///< details were dropped and the rest rounded to float32
  std::string notes;   ///< what else the writer wants back, e.g. a georeference; any text
  std::vector<BandDetails> bands;

  [[nodiscard]] GridReverseOptions options(int threads = 1) const {
    return {levels, mode, boundaries, threads};
  }
};

/// The bytes of a details file, version 1. All numbers are little-endian.
///
///     8  magic 89 'A' 'R' 'D' 0D 0A 1A 0A (a text-mode copy damages it visibly)
///     4  version                     4  length H of the header
///     8  length of the whole file    H  header: lines of key=value in UTF-8
///     .. blocks, the coarsest level first, each: 1 byte method (0 stored, 1 packed), 8 bytes size,
///        8 bytes stored size, the bytes (numbers split into planes of their 1st, 2nd, ... bytes)
///     4  CRC-32 of all before
///
/// `pack` empty: blocks are stored.
[[nodiscard]] Bytes encode_details(const DetailsFile& file, const Pack& pack = {});

/// Reads them back. Every size is checked against the header before anything is allocated, so no
/// bytes whatever make it crash or take more than some 1000 times their own size.
/// \throws InvalidDetails for bytes that are no details file, written by a newer version, cut off,
/// damaged (checksum), inconsistent, or packed when `unpack` is empty.
[[nodiscard]] DetailsFile decode_details(std::span<const std::uint8_t> bytes,
                                         const Unpack& unpack = {});

}  // namespace arete

// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <span>
#include <vector>

namespace arete {

/// Appends numbers to bytes, little-endian on every machine.
inline void put_integer(std::vector<std::uint8_t>& bytes, std::uint64_t value, int size) {
  for (int i = 0; i < size; ++i) bytes.push_back(static_cast<std::uint8_t>(value >> (8 * i)));
}

/// \pre bytes.size() >= size
[[nodiscard]] inline std::uint64_t get_integer(std::span<const std::uint8_t> bytes, int size) {
  std::uint64_t value = 0;
  for (int i = 0; i < size; ++i)
    value |= static_cast<std::uint64_t>(bytes[static_cast<std::size_t>(i)]) << (8 * i);
  return value;
}

/// Numbers as planes: the lowest bytes of all of them, then the second bytes, ... Neighbouring
/// numbers share their high bytes, so planes compress better than numbers. `width` 8: double, 4:
/// float32.
[[nodiscard]] inline std::vector<std::uint8_t> to_planes(const std::vector<double>& numbers,
                                                         int width) {
  std::vector<std::uint8_t> planes(numbers.size() * static_cast<std::size_t>(width));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::uint64_t bits = width == 8
                                   ? std::bit_cast<std::uint64_t>(numbers[i])
                                   : std::bit_cast<std::uint32_t>(static_cast<float>(numbers[i]));
    for (std::size_t k = 0; k < static_cast<std::size_t>(width); ++k)
      planes[k * numbers.size() + i] = static_cast<std::uint8_t>(bits >> (8 * k));
  }
  return planes;
}

/// \pre planes.size() == count * width
[[nodiscard]] inline std::vector<double> from_planes(std::span<const std::uint8_t> planes,
                                                     int width) {
  const std::size_t count = planes.size() / static_cast<std::size_t>(width);
  std::vector<double> numbers(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < static_cast<std::size_t>(width); ++k)
      bits |= static_cast<std::uint64_t>(planes[k * count + i]) << (8 * k);
    numbers[i] = width == 8
                     ? std::bit_cast<double>(bits)
                     : static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)));
  }
  return numbers;
}

}  // namespace arete

// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace arete {

/// Takes values off the front of a fuzzer's input; zeros once it is used up.
class ByteReader {
 public:
  ByteReader(const std::uint8_t* data, std::size_t size) : data_(data), left_(size) {}

  [[nodiscard]] bool empty() const { return left_ == 0; }

  template <class T>
  T take() {
    T value{};
    const std::size_t size = left_ < sizeof(T) ? left_ : sizeof(T);
    std::memcpy(&value, data_, size);
    skip(size);
    return value;
  }
  /// 0 .. count - 1
  int below(int count) { return take<std::uint8_t>() % count; }
  /// The text up to the next end of a line, or all.
  std::string line() {
    const std::string_view rest(reinterpret_cast<const char*>(data_), left_);
    const std::string text(rest.substr(0, rest.find('\n')));
    skip(text.size() < left_ ? text.size() + 1 : left_);
    return text;
  }

 private:
  void skip(std::size_t size) {
    data_ += size;
    left_ -= size;
  }

  const std::uint8_t* data_;
  std::size_t left_;
};

}  // namespace arete

// SPDX-License-Identifier: MIT
#pragma once

#include <charconv>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "arete/openmesh/mesh_io.h"

namespace arete::openmesh::detail {

/// Lines of a text file and the words on them, with line numbers for errors.
class Lines {
 public:
  explicit Lines(std::string_view text) : text_(text) {}

  /// Goes to the next line that is not empty after `#` comments are cut off; false at the end.
  bool next() {
    while (position_ < text_.size()) {
      const std::size_t end = std::min(text_.find('\n', position_), text_.size());
      std::string_view line = text_.substr(position_, end - position_);
      position_ = end + 1;
      ++number_;
      split(line.substr(0, line.find('#')));
      if (!words_.empty()) return true;
    }
    words_.clear();
    return false;
  }
  [[nodiscard]] const std::vector<std::string_view>& words() const { return words_; }
  [[nodiscard]] std::size_t size() const { return words_.size(); }
  /// Where the line after this one begins.
  [[nodiscard]] std::size_t position() const { return std::min(position_, text_.size()); }

  [[noreturn]] void fail(const std::string& what) const {
    throw MeshFileError("line " + std::to_string(number_) + ": " + what);
  }
  template <class Number>
  [[nodiscard]] Number number(std::size_t i) const {
    if (i >= words_.size()) fail("a number is missing");
    return parsed<Number>(words_[i]);
  }
  template <class Number>
  [[nodiscard]] Number parsed(std::string_view word) const {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size())
      fail("'" + std::string(word.substr(0, 40)) + "' is no number that fits here");
    return value;
  }

 private:
  void split(std::string_view line) {
    words_.clear();
    constexpr std::string_view blanks = " \t\r\v\f";
    for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
      const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
      words_.push_back(line.substr(begin, end - begin));
      begin = line.find_first_not_of(blanks, end);
    }
  }

  std::string_view text_;
  std::size_t position_ = 0;
  int number_ = 0;
  std::vector<std::string_view> words_;
};

/// Appends a number in the shortest form that reads back as the same.
template <class Number>
void append(std::string& text, Number value) {
  char buffer[40];
  text.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

/// 0..1 as a byte.
[[nodiscard]] inline std::uint8_t color_byte(double x) {
  return static_cast<std::uint8_t>(255 * (x > 0 ? (x < 1 ? x : 1) : 0) + 0.5);
}

/// The formats: contents of a file to a mesh, and back. \throws MeshFileError
[[nodiscard]] MeshData parse_obj(std::string_view text);
[[nodiscard]] MeshData parse_off(std::string_view text);
[[nodiscard]] MeshData parse_ply(std::string_view bytes);
[[nodiscard]] MeshData parse_stl(std::string_view bytes);
[[nodiscard]] std::string obj_text(const MeshData& mesh);
[[nodiscard]] std::string off_text(const MeshData& mesh);
[[nodiscard]] std::string ply_bytes(const MeshData& mesh);
[[nodiscard]] std::string stl_bytes(const MeshData& mesh);

}  // namespace arete::openmesh::detail

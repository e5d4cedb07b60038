// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <functional>
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

/// A file being written: text gathers here and goes on in large pieces.
class Output {
 public:
  using Next = std::function<void(std::string_view piece, double share)>;
  Output(std::size_t records, const MeshOutput& options, Next next)
      : single_precision(options.single_precision),
        comments_(options.comments),
        records_(records),
        next_(std::move(next)) {}

  /// A vertex or a face is complete.
  void record_done() {
    ++done_;
    if (text.size() >= piece) flush();
  }
  void flush() {
    next_(text, static_cast<double>(done_) / static_cast<double>(records_));
    text.clear();
  }
  /// Appends a coordinate as text.
  void coordinate(double x) {
    if (single_precision)
      append(text, static_cast<float>(x));
    else
      append(text, x);
  }

  /// Appends the comments, each on a line of its own after `mark`.
  void comments(const char* mark) {
    for (std::string comment : comments_) {
      std::replace(comment.begin(), comment.end(), '\n', ' ');
      text += mark + comment + '\n';
    }
  }

  std::string text;
  const bool single_precision;

 private:
  static constexpr std::size_t piece = 1 << 20;
  const std::vector<std::string>& comments_;
  std::size_t records_;
  std::size_t done_ = 0;
  Next next_;
};

/// The formats: contents of a file to a mesh, and back. \throws MeshFileError
[[nodiscard]] MeshData parse_obj(std::string_view text);
[[nodiscard]] MeshData parse_off(std::string_view text);
[[nodiscard]] MeshData parse_ply(std::string_view bytes);
[[nodiscard]] MeshData parse_stl(std::string_view bytes);
void write_obj(const MeshData& mesh, Output& out);
void write_off(const MeshData& mesh, Output& out);
void write_ply(const MeshData& mesh, Output& out);
void write_stl(const MeshData& mesh, Output& out);

}  // namespace arete::openmesh::detail

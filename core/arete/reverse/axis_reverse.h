// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <variant>

#include "arete/reverse/anchor_rows.h"
#include "arete/reverse/least_squares_reverse.h"
#include "arete/reverse/local_reverse.h"

namespace arete {

/// How coarse samples are found.
enum class ReverseMode {
  local,         ///< by short filters (local_reverse.h): fast, exact for dyadic schemes
  least_squares  ///< the best ones, by a banded solve (least_squares_reverse.h): every scheme
};

/// Reads `local` or `least-squares`. \throws InvalidField listing both for any other text.
[[nodiscard]] ReverseMode parse_reverse_mode(std::string_view text);
[[nodiscard]] std::string_view to_string(ReverseMode mode);

/// \throws InvalidScheme saying that the scheme has no local filters and what to do instead.
[[noreturn]] void refuse_local(const Mask& mask, const ReverseLevel& level);
/// \throws InvalidScheme saying that the coarse samples are not determined.
[[noreturn]] void refuse_least_squares(const Mask& mask, const ReverseLevel& level);

/// One reverse step along one axis, prepared: sizes, filters or factors, for any number of lines.
/// Over exact rationals, float or double. Analysis followed by synthesis is the identity for any
/// samples; fine samples that one step of subdivision made have details 0.
template <class R>
class AxisReverse {
 public:
  /// \throws InvalidField see ReverseLevel. \throws InvalidScheme if the scheme has no local
  /// reverse (mode local), or its coarse samples are not determined by the fine ones (least
  /// squares).
  AxisReverse(const Mask& mask, Index fine_count, Boundary boundary, ReverseMode mode)
      : level_(mask, fine_count, boundary), method_(prepared(mask, level_, boundary, mode)) {}

  [[nodiscard]] const ReverseLevel& level() const { return level_; }
  [[nodiscard]] Index fine_count() const { return level_.fine_count; }
  [[nodiscard]] Index coarse_count() const { return level_.coarse_count; }
  [[nodiscard]] Index detail_count() const { return level_.detail_count(); }

  /// The filters, where the axis is reversed by local ones and nothing is padded; otherwise
  /// nullptr.
  [[nodiscard]] const LocalReverse<R>* local() const {
    return level_.padding == 0 ? std::get_if<LocalReverse<R>>(&method_) : nullptr;
  }

  /// `coarse` and `details` take the results; they must not overlap `fine`.
  void analyse(Lines<const R> fine, Lines<R> coarse, Lines<R> details) const {
    if (level_.padding == 0) {
      analyse_padded(fine, coarse, details);
      return;
    }
    LineBuffer<R> buffer(level_.rows.count(), fine.lanes);
    const Lines<R> padded = buffer.lines();
    for (Index i = 0; i < fine.count; ++i) std::copy_n(fine[i], fine.lanes, padded[i]);
    for (Index k = 1; k <= level_.padding; ++k) {
      const R share = R(static_cast<int>(k)) / R(static_cast<int>(level_.padding + 1));
      R* appended = padded[fine.count + k - 1];
      std::fill_n(appended, fine.lanes, R(0));
      add_line(appended, fine[fine.count - 1], R(1) - share, fine.lanes);
      add_line(appended, fine[0], share, fine.lanes);
    }
    analyse_padded(padded, coarse, details);
  }

  void synthesise(Lines<const R> coarse, Lines<const R> details, Lines<R> fine) const {
    if (level_.padding == 0) {
      synthesise_padded(coarse, details, fine);
      return;
    }
    LineBuffer<R> padded(level_.rows.count(), fine.lanes);
    synthesise_padded(coarse, details, padded.lines());
    for (Index i = 0; i < fine.count; ++i) std::copy_n(padded.lines()[i], fine.lanes, fine[i]);
  }

 private:
  using Method = std::variant<LocalReverse<R>, LeastSquaresReverse<R>>;

  static Method prepared(const Mask& mask, const ReverseLevel& level, Boundary boundary,
                         ReverseMode mode) {
    if (mode == ReverseMode::local) {
      auto found = local_reverse<R>(mask, level, boundary);
      if (!found) refuse_local(mask, level);
      return std::move(*found);
    }
    LeastSquaresReverse<R> solver(synthesis_rows<R>(mask, level, boundary),
                                  anchor_rows(mask, level, boundary));
    if (!solver.regular()) refuse_least_squares(mask, level);
    return solver;
  }

  void analyse_padded(Lines<const R> fine, Lines<R> coarse, Lines<R> details) const {
    if (const auto* filters = std::get_if<LocalReverse<R>>(&method_)) {
      filters->analysis.multiply(fine, coarse);
      filters->detail.multiply(fine, coarse, details);
    } else {
      std::get<LeastSquaresReverse<R>>(method_).analyse(fine, coarse, details);
    }
  }

  void synthesise_padded(Lines<const R> coarse, Lines<const R> details, Lines<R> fine) const {
    if (const auto* filters = std::get_if<LocalReverse<R>>(&method_))
      filters->synthesis.multiply(coarse, details, fine);
    else
      std::get<LeastSquaresReverse<R>>(method_).synthesise(coarse, details, fine);
  }

  ReverseLevel level_;
  Method method_;
};

}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/refine/axis_plan.h"

#include <algorithm>
#include <string>

namespace arete {
namespace {

constexpr Index largest_count = Index{1} << 40;

Rational power_of(int base, int exponent) {
  return power(Rational(base), static_cast<unsigned>(exponent));
}

Index to_index(const Integer& value) { return static_cast<Index>(value); }

LevelRule filter(const Stencil& stencil) {
  // q_i = sum_k w_k p_{i + first + k} has a_{-(first + k)} = w_k.
  std::vector<Rational> reversed(stencil.weights.rbegin(), stencil.weights.rend());
  return {1, LaurentPolynomial<Rational>(-stencil.last(), std::move(reversed))};
}

// Every m-th coefficient from `phase` on: what computes only the samples m j + phase of a level.
LevelRule decimated(const LevelRule& rule, Index phase) {
  const Index lowest = ceil_divide(rule.symbol.lowest() - phase, rule.arity);
  const Index highest = floor_divide(rule.symbol.highest() - phase, rule.arity);
  std::vector<Rational> coefficients;
  for (Index k = lowest; k <= highest; ++k)
    coefficients.push_back(rule.symbol[static_cast<int>(rule.arity * k + phase)]);
  return {1, LaurentPolynomial<Rational>(static_cast<int>(lowest), std::move(coefficients))};
}

// -tau (m^N - 1)/(m - 1), or with the limit taken -tau m^N/(m - 1).
Rational lattice_shift(const Mask& mask, int levels, bool limit) {
  const Rational fine = power_of(mask.arity(), levels);
  return -mask.tau() * (limit ? fine : Rational(fine - 1)) / (mask.arity() - 1);
}

bool moves_samples(const AxisOptions& options) {
  return options.final_stencil && options.final_result == FinalResult::samples;
}

IndexRange intersection(IndexRange a, IndexRange b) {
  return {std::max(a.first, b.first), std::min(a.last, b.last)};
}

void check_size(const Mask& mask, Index count, int levels) {
  if (count < 1) throw InvalidField("an axis needs at least one sample");
  if (levels < 0)
    throw InvalidField("levels = " + std::to_string(levels) + " is negative; give 0 or more");
  Rational size = count;
  for (int level = 0; level < levels && size <= largest_count; ++level) size *= mask.arity();
  if (size > largest_count)
    throw InvalidField(std::to_string(count) + " samples refined " + std::to_string(levels) +
                       " times by " + std::to_string(mask.arity()) +
                       " exceed 2^40 samples along one axis; use fewer levels");
}

}  // namespace

AxisPlan AxisPlan::identity(Index count) {
  AxisPlan plan;
  plan.input_count_ = count;
  plan.ranges_ = {{0, count - 1}};
  return plan;
}

AxisPlan::AxisPlan(const Mask& mask, Index count, const AxisOptions& options)
    : input_count_(count), boundary_(options.boundary) {
  check_size(mask, count, options.levels);
  if (count == 1 && options.alignment == Alignment::nodes && boundary_ != Boundary::periodic &&
      boundary_ != Boundary::none && !options.final_stencil) {
    ranges_ = {{0, 0}};
    spacing_ = 1 / power_of(mask.arity(), options.levels);
    return;
  }
  plan_lattice(mask, options);
  if (ranges_.back().count() < 1)
    throw InvalidField("boundary none leaves no sample of an axis of " + std::to_string(count) +
                       "; give more samples or another boundary");
}

void AxisPlan::plan_lattice(const Mask& mask, const AxisOptions& options) {
  const bool limit = moves_samples(options);
  const Rational fine = power_of(mask.arity(), options.levels);
  const Rational shift = lattice_shift(mask, options.levels, limit);
  const Index total = to_index(boost::multiprecision::numerator(fine)) * input_count_;
  const Rational half(1, 2);

  IndexRange wanted;
  if (options.alignment == Alignment::cells) {
    // Cell centre j is sample j + offset of the lattice when the offset is an integer.
    const Rational offset = half - fine / 2 - shift;
    const Rational further_offset = Rational(mask.arity()) * half - fine * mask.arity() / 2 -
                                    lattice_shift(mask, options.levels + 1, limit);
    if (!is_integer(offset) && is_integer(further_offset)) {
      plan_further_level(mask, options, boost::multiprecision::numerator(further_offset));
      return;
    }
    const Integer nearest = floor(Rational(offset + half));
    misplacement_ = (nearest - offset) / fine;
    wanted = {to_index(nearest), to_index(nearest) + total - 1};
  } else if (boundary_ == Boundary::periodic) {
    wanted = {0, total - 1};
  } else {
    wanted = {to_index(ceil(Rational(-shift))),
              to_index(floor(Rational((input_count_ - 1) * fine - shift)))};
    // Without ghosts the lattice is cut by what can be computed, not by the nodes.
    if (boundary_ == Boundary::none) wanted = {-largest_count, largest_count};
  }

  // One sample is the same everywhere; whichever stands for it is said to lie where it lies.
  const bool constant = input_count_ == 1 && wanted.count() < 1;
  if (constant) wanted.last = wanted.first;

  rules_.assign(static_cast<std::size_t>(options.levels), {mask.arity(), mask.symbol()});
  if (options.final_stencil) rules_.push_back(filter(*options.final_stencil));
  ranges_ = ranges_back_from(wanted);
  first_position_ = constant ? Rational(0) : Rational((ranges_.back().first + shift) / fine);
  spacing_ = 1 / fine;
}

void AxisPlan::plan_further_level(const Mask& mask, const AxisOptions& options,
                                  const Integer& offset) {
  LevelRule last{mask.arity(), mask.symbol()};
  if (options.final_stencil) last.symbol = last.symbol * filter(*options.final_stencil).symbol;
  const Index phase = to_index(offset);
  rules_.assign(static_cast<std::size_t>(options.levels), {mask.arity(), mask.symbol()});
  rules_.push_back(decimated(last, phase));
  const Rational fine = power_of(mask.arity(), options.levels);
  const Index total = to_index(boost::multiprecision::numerator(fine)) * input_count_;
  ranges_ = ranges_back_from({0, total - 1});
  first_position_ = (ranges_.back().first + Rational(1, 2)) / fine - Rational(1, 2);
  spacing_ = 1 / fine;
}

std::vector<IndexRange> AxisPlan::ranges_back_from(IndexRange last) const {
  if (boundary_ == Boundary::none) {
    IndexRange computable{0, input_count_ - 1};
    for (const LevelRule& rule : rules_) {
      computable = rule.computable(computable);
      if (computable.count() < 1) return {IndexRange{}};
    }
    last = intersection(last, computable);
  }
  std::vector<IndexRange> ranges(rules_.size() + 1);
  ranges.back() = last;
  for (std::size_t level = rules_.size(); level-- > 0;)
    ranges[level] = rules_[level].needed(ranges[level + 1]);
  return ranges;
}

std::vector<IndexRange> AxisPlan::ranges_for(IndexRange outputs) const {
  const Index origin = ranges_.back().first;
  std::vector<IndexRange> ranges(rules_.size() + 1);
  ranges.back() = {origin + outputs.first, origin + outputs.last};
  for (std::size_t level = rules_.size(); level-- > 0;)
    ranges[level] = rules_[level].needed(ranges[level + 1]);
  return ranges;
}

void AxisPlan::pad_levels(std::size_t count) {
  while (rules_.size() < count) {
    rules_.insert(rules_.begin(), LevelRule{1, LaurentPolynomial<Rational>(1)});
    ranges_.insert(ranges_.begin(), ranges_.front());
  }
}

AxisPlacement AxisPlan::placement() const {
  return {output_count(), to_double(first_position_), to_double(spacing_)};
}

Index AxisPlan::reach() const {
  if (rules_.empty()) return 0;
  // The rules are the same everywhere, so the cell [0, 1] stands for all.
  const Index lowest = to_index(ceil(Rational(-first_position_ / spacing_)));
  const Index highest = to_index(floor(Rational((1 - first_position_) / spacing_)));
  const IndexRange read = ranges_for({lowest, highest}).front();
  return std::max({Index{0}, -read.first, read.last - 1});
}

}  // namespace arete

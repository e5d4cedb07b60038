// SPDX-License-Identifier: GPL-3.0-or-later
#include "arete/meshlab/axis_samples.h"

#include <algorithm>
#include <string>

#include "arete/field/at.h"

namespace arete::meshlab {
namespace {

Index modulo(Index a, Index n) { return ((a % n) + n) % n; }

Index to_index(const Integer& value) { return static_cast<Index>(value); }

}  // namespace

AxisSamples::AxisSamples(const AxisPlan& plan, bool wraps)
    : count_(plan.input_count()), wraps_(wraps), spacing_(plan.spacing()) {
  locate_samples(plan);
  const std::size_t least = wraps ? 3 : 2;
  if (samples_.size() < least)
    throw InvalidField("only " + std::to_string(samples_.size()) +
                       " of the new vertices along a "
                       "row or column of " +
                       std::to_string(count_) +
                       " could be computed without looking beyond the rim; choose another boundary "
                       "than none, or fewer levels");
  locate_cells();
  find_successors();
}

void AxisSamples::locate_samples(const AxisPlan& plan) {
  const Rational& first = plan.first_position();
  const Rational& spacing = plan.spacing();
  Index begin = 0;
  Index end = plan.output_count();
  if (!wraps_) {
    begin = to_index(ceil(Rational(-first / spacing)));
    end = to_index(floor(Rational((count_ - 1 - first) / spacing))) + 1;
    if (plan.boundary() != Boundary::periodic) {
      begin = std::max(begin, Index{0});
      end = std::min(end, plan.output_count());
    }
  }
  for (Index i = begin; i < end; ++i) {
    const Rational place = first + i * spacing;
    const Index whole = to_index(floor(place));
    Index cell = whole;
    if (!wraps_) cell = std::clamp(whole, Index{0}, std::max(count_ - 2, Index{0}));
    places_.push_back(place);
    samples_.push_back({modulo(i, plan.output_count()), wraps_ ? modulo(whole, count_) : cell,
                        to_double(Rational(place - cell))});
  }
}

void AxisSamples::locate_cells() {
  const std::size_t cells = samples_.size() - (wraps_ ? 0 : 1);
  for (std::size_t i = 0; i < cells; ++i) {
    Index owner = to_index(floor(Rational(places_[i] + spacing_ / 2)));
    if (!wraps_) owner = std::clamp(owner, Index{0}, count_ - 2);
    const Rational begin = places_[i] - owner;
    cells_.push_back({wraps_ ? modulo(owner, count_) : owner, to_double(begin),
                      to_double(Rational(begin + spacing_))});
  }
}

void AxisSamples::find_successors() {
  const auto size = static_cast<Index>(samples_.size());
  successors_.assign(at(count_), -1);
  for (Index i = 0; i < count_; ++i) {
    // The nearest of the lattice, the earlier of two, moved into what is there.
    Index nearest = to_index(ceil(Rational((i - places_.front()) / spacing_ - Rational(1, 2))));
    nearest = wraps_ ? modulo(nearest, size) : std::clamp(nearest, Index{0}, size - 1);
    Rational distance = abs(Rational(places_[at(nearest)] - i));
    if (wraps_) distance = std::min(distance, Rational(count_ - distance));
    if (distance < spacing_) successors_[at(i)] = nearest;
  }
}

}  // namespace arete::meshlab

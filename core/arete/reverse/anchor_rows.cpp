// SPDX-License-Identifier: MIT
#include "arete/reverse/anchor_rows.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <string>

#include "arete/reverse/synthesis_rows.h"

namespace arete {
namespace {

using Dense = std::vector<std::vector<double>>;

constexpr double never = std::numeric_limits<double>::infinity();

// A phase that can be anchored: its symbol stays away from zero on the unit circle.
struct Phase {
  int phase = 0;
  double distance = 0;  // of the symbol from zero
  Index turns = 0;      // of the symbol around zero: its rows belong to columns that many further
};

Phase examined(const PhaseStencil<double>& stencil, int phase) {
  constexpr int samples = 256;
  Phase result{phase, never, stencil.first};
  std::complex<double> last = 0;
  double angle = 0;
  for (int i = 0; i <= samples; ++i) {
    const std::complex<double> z = std::polar(1.0, 2 * std::numbers::pi * i / samples);
    std::complex<double> value = 0;
    for (std::size_t k = stencil.weights.size(); k-- > 0;) value = value * z + stencil.weights[k];
    result.distance = std::min(result.distance, std::abs(value));
    if (i > 0) angle += std::arg(value / last);
    last = value;
  }
  // Rounded, so that equal phases keep their order on every machine.
  result.distance = std::round(1e6 * result.distance) / 1e6;
  if (result.distance > 0)
    result.turns += static_cast<Index>(std::llround(angle / (2 * std::numbers::pi)));
  return result;
}

// The phases that can be anchored, best first.
std::vector<Phase> anchor_phases(const Mask& mask) {
  const PhasedRule<double> rule(LevelRule{mask.arity(), mask.symbol()});
  std::vector<Phase> found;
  for (int r = 0; r < rule.arity; ++r) {
    const Phase phase = examined(rule.phases[static_cast<std::size_t>(r)], r);
    if (phase.distance > 1e-3) found.push_back(phase);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const Phase& a, const Phase& b) { return a.distance > b.distance; });
  return found;
}

// The largest |entry| of S_rest S_anchors^-1, infinite when there is no inverse.
double amplification(const SparseRows<double>& s, const std::vector<Index>& anchors) {
  const auto n = static_cast<std::size_t>(s.cols());
  // Columns of [S_anchors^T | S_rest^T], eliminated with row exchanges.
  Dense work(n, std::vector<double>());
  const auto append = [&](Index row) {
    for (auto& line : work) line.push_back(0);
    for (const auto& [col, weight] : s.row(row))
      work[static_cast<std::size_t>(col)].back() = weight;
  };
  for (const Index row : anchors) append(row);
  for (Index row = 0; row < s.rows(); ++row)
    if (!std::binary_search(anchors.begin(), anchors.end(), row)) append(row);
  const std::size_t width = work.front().size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t pivot = k;
    for (std::size_t i = k; i < n; ++i)
      if (std::abs(work[i][k]) > std::abs(work[pivot][k])) pivot = i;
    if (std::abs(work[pivot][k]) < 1e-9) return never;
    std::swap(work[k], work[pivot]);
    for (std::size_t i = 0; i < n; ++i) {
      if (i == k || work[i][k] == 0) continue;
      const double factor = work[i][k] / work[k][k];
      for (std::size_t j = k; j < width; ++j) work[i][j] -= factor * work[k][j];
    }
  }
  double largest = 0;
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = n; j < width; ++j)
      largest = std::max(largest, std::abs(work[i][j] / work[i][i]));
  return largest;
}

using Sets = std::vector<std::vector<Index>>;

// All ways to take `count` of the pool.
Sets choices(const std::vector<Index>& pool, Index count) {
  Sets found{{}};
  for (Index step = 0; step < count; ++step) {
    Sets longer;
    for (const auto& chosen : found)
      for (const Index i : pool)
        if (chosen.empty() || i > chosen.back()) {
          longer.push_back(chosen);
          longer.back().push_back(i);
        }
    found = std::move(longer);
  }
  return found;
}

// The rows of the phase that belong to columns 0..n-1; where such a row lies beyond an end of the
// axis, some other row near that end stands for it.
Sets candidates(const ReverseLevel& level, const Phase& phase) {
  const Index m = level.arity;
  const Index count = level.rows.count();
  std::vector<Index> inside;
  Index before = 0;
  Index behind = 0;
  for (Index j = 0; j < level.coarse_count; ++j) {
    const Index i = m * (j - phase.turns) + phase.phase - level.rows.first;
    if (i < 0)
      ++before;
    else if (i >= count)
      ++behind;
    else
      inside.push_back(i);
  }
  constexpr Index most = 3;
  if (before > most || behind > most) return {};
  const auto pool = [&](Index first, Index last) {
    std::vector<Index> rows;
    for (Index i = std::max<Index>(0, first); i <= std::min(last, count - 1); ++i)
      if (!std::binary_search(inside.begin(), inside.end(), i)) rows.push_back(i);
    return rows;
  };
  Sets found;
  for (const auto& left : choices(pool(0, m * (before + 1) - 1), before))
    for (const auto& right : choices(pool(count - m * (behind + 1), count - 1), behind)) {
      std::vector<Index> all = inside;
      all.insert(all.end(), left.begin(), left.end());
      all.insert(all.end(), right.begin(), right.end());
      std::sort(all.begin(), all.end());
      if (std::adjacent_find(all.begin(), all.end()) == all.end()) found.push_back(std::move(all));
    }
  return found;
}

// On a closed axis every phase is complete.
std::vector<Index> rows_of_phase(const ReverseLevel& level, const Phase& phase) {
  std::vector<Index> rows;
  for (Index i = phase.phase; i < level.rows.count(); i += level.arity) rows.push_back(i);
  return rows;
}

[[noreturn]] void refuse(const Mask& mask) {
  throw InvalidScheme("the scheme with the mask " + coefficients_text(mask) +
                      " cannot be reversed by least squares: no phase of its mask determines the "
                      "coarse samples; choose another scheme");
}

}  // namespace

std::vector<Index> anchor_rows(const Mask& mask, const ReverseLevel& level, Boundary boundary) {
  if (level.coarse_count == 1) return {0};
  const std::vector<Phase> phases = anchor_phases(mask);
  if (phases.empty()) refuse(mask);
  if (level.closed) return rows_of_phase(level, phases.front());

  // The ends of a long axis look like those of a short one: decide there.
  const Index width = static_cast<Index>(mask.coefficients().size()) / mask.arity() + 2;
  const Index cut = std::max<Index>(0, level.coarse_count - (3 * width + 8));
  const ReverseLevel small(mask, level.fine_count - cut * mask.arity(), boundary);
  const SparseRows<double> s = synthesis_rows<double>(mask, small, boundary);
  double best = never;
  std::vector<Index> anchors;
  for (const Phase& phase : phases) {
    for (std::vector<Index>& candidate : candidates(small, phase)) {
      const double amplified = std::round(1e6 * amplification(s, candidate)) / 1e6;
      if (amplified >= best) continue;
      best = amplified;
      anchors = std::move(candidate);
    }
    if (best < 8) break;
  }
  if (best == never || best > 1e6) refuse(mask);
  // Put the samples that were cut out of the middle back.
  const Index middle = anchors[anchors.size() / 2];
  std::vector<Index> all;
  for (const Index i : anchors) {
    if (i <= middle) all.push_back(i);
    if (i == middle)
      for (Index k = 1; k <= cut; ++k) all.push_back(i + k * mask.arity());
    if (i > middle) all.push_back(i + cut * mask.arity());
  }
  return all;
}

}  // namespace arete

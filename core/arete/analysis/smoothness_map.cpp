// SPDX-License-Identifier: MIT
#include "arete/analysis/smoothness_map.h"

#include <atomic>

#include "arete/parallel/for_each_band.h"

namespace arete {

SmoothnessOptions map_options(int max_power) {
  SmoothnessOptions options;
  options.max_power = max_power;
  options.work_budget = 500'000;
  options.jsr.max_word_length = 4;
  options.jsr.beam = 16;
  options.jsr.max_vertices = 0;
  options.jsr.norm_budget = 4'000;
  return options;
}

namespace {

// For the few points that the first look leaves open: longer words, small polytopes.
SmoothnessOptions thorough(SmoothnessOptions options) {
  options.jsr.max_word_length = 12;
  options.jsr.beam = 40;
  options.jsr.max_vertices = 200;
  options.jsr.norm_budget = 50'000;
  return options;
}

bool is_open(const Smoothness& found) { return found.refuted_at != found.certified + 1; }

}  // namespace

std::vector<MapCell> smoothness_map(
    const std::vector<Rational>& xs, const std::vector<Rational>& ys,
    const std::function<std::optional<Mask>(const Rational& x, const Rational& y)>& mask_at,
    const SmoothnessOptions& options, const std::function<bool(std::size_t done)>& progress) {
  std::vector<MapCell> cells(xs.size() * ys.size());
  std::atomic<std::size_t> done = 0;
  std::atomic<bool> stopped = false;
  for_each_band(static_cast<std::int64_t>(cells.size()), 16, 0, [&](auto first, auto count) {
    const auto end = static_cast<std::size_t>(first + count);
    for (auto at = static_cast<std::size_t>(first); at != end && !stopped; ++at) {
      if (const auto mask = mask_at(xs[at % xs.size()], ys[at / xs.size()])) {
        Smoothness found = analyze_smoothness(*mask, options);
        if (is_open(found)) found = analyze_smoothness(*mask, thorough(options));
        MapCell& cell = cells[at];
        cell.valid = true;
        cell.certified = found.certified;
        cell.refuted_next = found.refuted_at == found.certified + 1;
        cell.stable = found.hoelder.stability == Stability::stable;
        cell.hoelder_lower = found.hoelder.lower;
      }
      ++done;
    }
    if (progress && !progress(done)) stopped = true;
  });
  return cells;
}

}  // namespace arete

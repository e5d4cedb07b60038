// SPDX-License-Identifier: MIT
#include "cli/map_outlines.h"

#include <algorithm>
#include <limits>

#include "arete/analysis/theorem.h"
#include "cli/interruption.h"

namespace arete::cli {
namespace {

constexpr int samples_along = 161;

using Extent = PrintedRegion::Extent;

struct Sampled {
  PrintedRegion region;
  std::vector<Grid<double>> residuals;
};

bool vanishes(const Grid<double>& field) {
  const auto values = field.samples();
  return std::all_of(values.begin(), values.end(), [](double x) { return x == 0; });
}

bool changes_sign_within(const Grid<double>& field, const Grid<double>& margin) {
  bool positive = false, negative = false;
  for (std::size_t i = 0; i < margin.samples().size(); ++i)
    if (margin.samples()[i] < 0) {
      positive = positive || field.samples()[i] >= 0;
      negative = negative || field.samples()[i] <= 0;
    }
  return positive && negative;
}

PrintedRegion finished(Sampled sampled) {
  PrintedRegion region = std::move(sampled.region);
  std::erase_if(sampled.residuals, vanishes);
  const auto inside = [](double margin) { return margin < 0; };
  const auto values = region.margin.samples();
  if (std::none_of(values.begin(), values.end(), inside)) return region;
  if (sampled.residuals.empty()) {
    region.extent =
        std::all_of(values.begin(), values.end(), inside) ? Extent::everywhere : Extent::inside;
  } else if (sampled.residuals.size() > 1) {
    region.extent = Extent::points;
  } else if (changes_sign_within(sampled.residuals.front(), region.margin)) {
    region.extent = Extent::line;
    region.equality = std::move(sampled.residuals.front());
  }
  return region;
}

}  // namespace

std::vector<PrintedRegion> printed_regions(const MapPlane& plane, const MapRange& x,
                                           const MapRange& y) {
  const int cols = x.values.front() == x.values.back() ? 2 : samples_along;
  const int rows = y.values.front() == y.values.back() ? 2 : samples_along;
  const auto outside = std::numeric_limits<double>::infinity();
  std::vector<Sampled> all;
  for (int r = 0; r < rows; ++r) {
    stop_if_interrupted();
    for (int c = 0; c < cols; ++c) {
      const auto scheme =
          plane.scheme(x.at(Rational(c) / (cols - 1)), y.at(Rational(r) / (rows - 1)));
      if (!scheme) continue;
      for (const TheoremResult& theorem : theorems_for(*scheme)) {
        const auto margin = region_margin(theorem);
        if (!margin) continue;
        const std::string name = theorem.name.find("C^") == std::string::npos
                                     ? theorem.name + ", C^" + std::to_string(theorem.claims)
                                     : theorem.name;
        auto known = std::find_if(all.begin(), all.end(),
                                  [&](const auto& one) { return one.region.name == name; });
        if (known == all.end()) {
          const Grid<double> nothing({rows, cols}, 0.0);
          known =
              all.insert(known, {{name, Grid<double>({rows, cols}, outside), Extent::nowhere, {}},
                                 {theorem.residuals.size(), nothing}});
        }
        known->region.margin(r, c) = *margin;
        for (std::size_t k = 0; k < theorem.residuals.size(); ++k)
          known->residuals[k](r, c) = to_double(theorem.residuals[k]);
      }
    }
  }
  std::vector<PrintedRegion> regions;
  for (Sampled& one : all) regions.push_back(finished(std::move(one)));
  return regions;
}

}  // namespace arete::cli

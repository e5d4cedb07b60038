// SPDX-License-Identifier: MIT
#include "arete/refine/closing_gain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

namespace arete {
namespace {

// A rule as a filter: |a(e^{-2 pi i f})|^2 over that at f = 0; f in cycles a sample of its result.
struct Filter {
  int arity = 1;
  std::vector<double> coefficients{1};

  Filter() = default;
  explicit Filter(const LevelRule& rule) : arity(rule.arity), coefficients() {
    for (const Rational& a : rule.symbol.coefficients())
      coefficients.push_back(to_double(a) / rule.arity);
  }

  [[nodiscard]] double response(double f) const {
    const std::complex<double> z = std::polar(1.0, -2 * std::numbers::pi * f);
    std::complex<double> sum = 0;
    for (std::size_t i = coefficients.size(); i-- > 0;) sum = sum * z + coefficients[i];
    return std::norm(sum);
  }
};

// One axis from the last displacement on: the step that made it, and the filters behind it.
struct Axis {
  Filter step;
  std::vector<Filter> filters;

  explicit Axis(const AxisPlan& plan) {
    for (const LevelRule& rule : plan.rules()) {
      if (rule.arity > 1) {
        step = Filter(rule);
        filters.clear();
      } else {
        filters.emplace_back(rule);
      }
    }
  }

  // What the filters leave of the last displacement.
  [[nodiscard]] double filtered(double f) const {
    double power = 1;
    for (const Filter& filter : filters) power *= filter.response(f);
    return power;
  }
};

// Levels looked at: enough that what older ones leave in the last octaves is nothing.
constexpr int levels = 12;
using Power = std::array<double, levels>;

// Mean power in the ring low <= |f| < high of the displacements of the last level, the one before,
// and so on, as they are without closing gain.
Power power_between(double low, double high, const Axis& x, const Axis& y, double roughness) {
  constexpr int radii = 24;
  constexpr int angles = 12;
  const double growth = std::pow(x.step.arity * y.step.arity, 1 + roughness);
  Power power{};
  double weights = 0;
  for (int i = 0; i < radii; ++i) {
    const double radius = low * std::pow(high / low, (i + 0.5) / radii);
    const double weight = radius * radius;  // of a ring whose width grows with its radius
    weights += angles * weight;
    for (int j = 0; j < angles; ++j) {
      const double angle = (j + 0.5) / angles * std::numbers::pi / 2;
      double fx = radius * std::cos(angle);
      double fy = radius * std::sin(angle);
      double shaped = weight * x.filtered(fx) * y.filtered(fy);
      for (double& of_level : power) {
        of_level += shaped;
        shaped *= x.step.response(fx) * y.step.response(fy) * growth;
        fx *= x.step.arity;
        fy *= y.step.arity;
      }
    }
  }
  for (double& of_level : power) of_level /= weights;
  return power;
}

}  // namespace

ClosingGain closing_gain(const AxisPlan& x, const AxisPlan& y, double roughness) {
  const Axis along_x(x);
  const Axis along_y(y);
  const double area = along_x.step.arity * along_y.step.arity;
  if (area < 2) return {};
  const auto octave = [&](int below) {
    const double high = 0.5 * std::pow(area, -0.5 * below);
    return power_between(high / std::sqrt(area), high, along_x, along_y, roughness);
  };
  // The power of the last two octaves (rows of c) shall be that of one further down, times the
  // power law: two equations, linear in the squares of the two gains.
  constexpr int inner = 3;
  const Power reference = octave(inner);
  std::array<Power, 2> c{octave(0), octave(1)};
  std::array<double, 2> rest{};
  for (int b = 0; b < 2; ++b) {
    auto& row = c[static_cast<std::size_t>(b)];
    for (std::size_t j = 0; j < row.size(); ++j) {
      row[j] -= std::pow(area, -(1 + roughness) * (inner - b)) * reference[j];
      if (j > 1) rest[static_cast<std::size_t>(b)] -= row[j];
    }
  }
  const double determinant = c[0][0] * c[1][1] - c[0][1] * c[1][0];
  double last = (rest[0] * c[1][1] - c[0][1] * rest[1]) / determinant;
  double before = (c[0][0] * rest[1] - rest[0] * c[1][0]) / determinant;
  // Where older levels put more there than asked, as little as possible is added.
  if (last < 0) {
    last = 0;
    before = rest[1] / c[1][1];
  } else if (before < 0) {
    before = 0;
    last = rest[0] / c[0][0];
  }
  constexpr double largest = 4;
  return {std::sqrt(std::clamp(last, 0.0, largest)), std::sqrt(std::clamp(before, 0.0, largest))};
}

}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/variational/cardinal.h"

#include <cmath>
#include <numbers>
#include <string>

#include "arete/algebra/real_roots.h"

namespace arete {
namespace {

bool is_unit(const Stencil& limit) {
  return limit.first == 0 && limit.weights.size() == 1 && limit.weights.front() == 1;
}

// |w(e^it)|^2 = r_0 + 2 sum_k r_k T_k(cos t) as a polynomial in cos t, exact.
Coefficients squared_modulus(const std::vector<Rational>& w) {
  Coefficients result(w.size(), Rational(0));
  Coefficients before{};                // T_{k-1}
  Coefficients chebyshev{Rational(1)};  // T_k
  for (std::size_t k = 0; k < w.size(); ++k) {
    Rational correlation = 0;
    for (std::size_t i = 0; i + k < w.size(); ++i) correlation += w[i] * w[i + k];
    if (k > 0) correlation *= 2;
    for (std::size_t i = 0; i < chebyshev.size(); ++i) result[i] += correlation * chebyshev[i];
    // T_{k+1} = 2 x T_k - T_{k-1}, with T_1 = x.
    Coefficients next(chebyshev.size() + 1, Rational(0));
    for (std::size_t i = 0; i < chebyshev.size(); ++i)
      next[i + 1] = (k == 0 ? 1 : 2) * chebyshev[i];
    for (std::size_t i = 0; i < before.size(); ++i) next[i] -= before[i];
    before = std::move(chebyshev);
    chebyshev = std::move(next);
  }
  return trimmed(std::move(result));
}

// The wave on which |w| is least, in samples.
double weakest_wave(const std::vector<Rational>& w) {
  double least = 1e300;
  double angle = 0;
  for (int i = 1; i <= 720; ++i) {
    const double t = std::numbers::pi * i / 720;
    double re = 0, im = 0;
    for (std::size_t k = 0; k < w.size(); ++k) {
      re += to_double(w[k]) * std::cos(t * static_cast<double>(k));
      im += to_double(w[k]) * std::sin(t * static_cast<double>(k));
    }
    if (std::hypot(re, im) < least) {
      least = std::hypot(re, im);
      angle = t;
    }
  }
  return 2 * std::numbers::pi / angle;
}

std::string short_number(double value) {
  std::string text = std::to_string(value);
  return text.substr(0, text.find('.') + 3);
}

void check_well_posed(const Stencil& limit) {
  if (limit.weights.empty()) throw InvalidField("a limit stencil without weights has no limit");
  const Coefficients modulus = squared_modulus(limit.weights);
  if (!modulus.empty() && distinct_real_roots(modulus, -1, 1) == 0) return;
  throw InvalidField(
      "the limit cannot be made to pass through data: control points that alternate "
      "with a period of " +
      short_number(weakest_wave(limit.weights)) +
      " samples have limit 0, so nothing in the data determines them; choose another "
      "scheme, or refine without interpolation");
}

template <class R>
R weight_of(const Rational& weight) {
  if constexpr (std::is_same_v<R, Rational>)
    return weight;
  else
    return to_double(weight);
}

}  // namespace

template <class R>
CardinalAxis<R>::CardinalAxis(const Stencil& limit, Boundary before, Boundary after, Index count)
    : count_(count), folded_(before == Boundary::periodic) {
  if (count < 1) throw InvalidField("an axis needs at least one sample");
  check_well_posed(limit);
  if ((before == Boundary::periodic) != (after == Boundary::periodic))
    throw InvalidField("an axis is periodic at both ends or at none");
  if (is_unit(limit)) return;
  if (before == Boundary::none || after == Boundary::none)
    throw InvalidField(
        "boundary none has fewer limit values than control points, so that data do "
        "not determine them; choose extrapolate, clamp, reflect or periodic");
  if (count == 1) return;  // weights sum to 1
  // Ghosts are made of samples no further from the end than they are themselves.
  const Index reach = std::max<Index>({1, -limit.first, limit.last()});
  Index lower = std::min(folded_ ? 2 * reach : reach, count - 1);
  // So few samples that ghosts wrap around more than once.
  if (count <= 2 * reach + 1) lower = count - 1;
  system_.emplace(count, lower, lower);
  for (Index i = 0; i < count; ++i)
    for (std::size_t k = 0; k < limit.weights.size(); ++k) {
      const R weight = weight_of<R>(limit.weights[k]);
      const Index index = i + limit.first + static_cast<Index>(k);
      const Continuation from = continued(index < 0 ? before : after, index, count);
      R& near = system_->at(place(i), place(from.near));
      near = near + weight * R(static_cast<long long>(1 + from.steps));
      if (from.steps == 0) continue;
      R& far = system_->at(place(i), place(from.far));
      far = far - weight * R(static_cast<long long>(from.steps));
    }
  if (!system_->factor())
    throw InvalidField("the limit cannot be made to pass through " + std::to_string(count) +
                       " samples with boundary " + std::string(to_string(before)) +
                       ": the system is singular; choose another boundary or scheme");
  check_growth(limit);
}

template <class R>
void CardinalAxis<R>::check_growth(const Stencil& limit) const {
  if constexpr (!std::is_same_v<R, Rational>) {
    std::vector<R> probe(static_cast<std::size_t>(count_));
    std::uint64_t state = 0x9E3779B97F4A7C15ULL;
    for (int kind = 0; kind < 4; ++kind) {
      for (std::size_t i = 0; i < probe.size(); ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const bool up = kind == 0 ? i % 2 == 0 : (state >> 63U) == 0;
        probe[i] = up ? 1 : -1;
      }
      solve(probe.data());
      for (const R& value : probe)
        if (!(std::abs(value) <= largest_growth))
          throw InvalidField("the limit cannot be made to pass through " + std::to_string(count_) +
                             " samples: waves of about " +
                             short_number(weakest_wave(limit.weights)) +
                             " samples would be magnified beyond 1e8; choose another boundary or "
                             "scheme, or refine without interpolation");
    }
  }
}

// A closed axis is folded, 0, n-1, 1, n-2, ..., so that its cyclic band becomes a plain one.
template <class R>
Index CardinalAxis<R>::place(Index i) const {
  if (!folded_) return i;
  return 2 * i < count_ ? 2 * i : 2 * (count_ - 1 - i) + 1;
}

template <class R>
void CardinalAxis<R>::solve_lines(R* values, Index width, Index stride) const {
  if (!system_) return;
  std::vector<R*> rows(static_cast<std::size_t>(count_));
  for (Index i = 0; i < count_; ++i) rows[static_cast<std::size_t>(place(i))] = values + i * stride;
  system_->solve(rows, width);
}

Index cardinal_reach(const Stencil& limit, double tolerance) {
  if (is_unit(limit)) return 0;
  for (Index half = 64;; half *= 4) {
    const CardinalAxis<double> axis(limit, Boundary::periodic, 2 * half + 1);
    std::vector<double> answer(static_cast<std::size_t>(2 * half + 1), 0);
    answer[static_cast<std::size_t>(half)] = 1;
    axis.solve(answer.data());
    // What lies further than h from the impulse, summed from outside.
    double tail = 0;
    for (Index h = half; h > 0; --h) {
      tail += std::abs(answer[static_cast<std::size_t>(half - h)]) +
              std::abs(answer[static_cast<std::size_t>(half + h)]);
      if (tail > tolerance) {
        if (h < half / 2) return h;
        break;  // the ends still feel it: look at a longer axis
      }
    }
    if (tail <= tolerance) return 0;
    if (half > 100'000)
      throw InvalidField(
          "the influence of a sample reaches further than 100000 samples; choose "
          "another scheme, or refine without interpolation");
  }
}

template <class T>
Grid<T> cardinal_control(GridView<const T> samples, const Stencil& limit_x, const Stencil& limit_y,
                         const Boundaries& boundaries) {
  const CardinalAxis<double> x(limit_x, boundaries.x, samples.cols());
  const CardinalAxis<double> y(limit_y, boundaries.y, samples.rows());
  Grid<double> work(samples.extent());
  for (Index r = 0; r < samples.rows(); ++r) {
    for (Index c = 0; c < samples.cols(); ++c) {
      if (!std::isfinite(samples(r, c)))
        throw InvalidField("the sample in row " + std::to_string(r) + ", column " +
                           std::to_string(c) +
                           " is missing, and the limit cannot be made to pass "
                           "through it; fill the holes, or refine without interpolation");
      work(r, c) = static_cast<double>(samples(r, c));
    }
    x.solve(work.row(r));
  }
  y.solve_lines(work.row(0), work.cols(), work.cols());
  Grid<T> control(samples.extent());
  for (std::size_t i = 0; i < work.samples().size(); ++i)
    control.samples()[i] = static_cast<T>(work.samples()[i]);
  return control;
}

template class CardinalAxis<double>;
template class CardinalAxis<Rational>;
template Grid<float> cardinal_control(GridView<const float>, const Stencil&, const Stencil&,
                                      const Boundaries&);
template Grid<double> cardinal_control(GridView<const double>, const Stencil&, const Stencil&,
                                       const Boundaries&);

}  // namespace arete

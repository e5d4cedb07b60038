// SPDX-License-Identifier: MIT
#include "arete/fit/fit_scheme.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "arete/fit/gauss_newton.h"
#include "arete/metrics/spectrum.h"

namespace arete {
namespace {

using Values = std::vector<double>;

// Predicted heights where they count, 0 elsewhere.
Values heights_model(const FitData& data, const std::vector<char>& counts,
                     const Grid<double>& predicted) {
  Values values(counts.size(), 0.0);
  for (Index r = 0; r < data.truth.rows(); ++r)
    for (Index c = 0; c < data.truth.cols(); ++c) {
      const auto i = static_cast<std::size_t>(r * data.truth.cols() + c);
      if (counts[i] != 0) values[i] = predicted(r, c);
    }
  return values;
}

// Logarithms of the power in the octaves that the coarse samples do not hold.
Values spectrum_model(const FitData& data, GridView<const double> heights) {
  Values values;
  for (const SpectrumBin& bin : spectrum_bins(profile_spectrum(heights), 0.25 / data.factor, 0.5))
    values.push_back(bin.power > 0 ? std::log(bin.power) : -700);
  return values;
}

Grid<double> part(const Grid<double>& field, Extent extent) {
  Grid<double> result(extent);
  for (Index r = 0; r < extent.rows; ++r)
    std::copy_n(field.row(r), static_cast<std::size_t>(extent.cols), result.row(r));
  return result;
}

// Prediction errors count only where every member predicts: what the start leaves out is left out.
void drop_missing(const FitData& data, const Grid<double>& predicted, std::vector<char>& counts) {
  for (Index r = 0; r < data.truth.rows(); ++r)
    for (Index c = 0; c < data.truth.cols(); ++c)
      if (!std::isfinite(predicted(r, c)))
        counts[static_cast<std::size_t>(r * data.truth.cols() + c)] = 0;
}

double root_mean(double squares, const std::vector<char>& counts) {
  return std::sqrt(squares / static_cast<double>(std::count(counts.begin(), counts.end(), 1)));
}

// Different members can have nearly the same spectrum: the nearest of those that are reached from
// starts around the given one.
LeastSquares from_many_starts(const Model& model, const Values& target, const Values& origin) {
  const std::vector<char> all(target.size(), 1);
  LeastSquares best = gauss_newton(model, target, all, origin, 1e-4);
  for (std::size_t i = 0; i < origin.size(); ++i)
    for (const double away : {-0.1, -0.04, 0.04, 0.1}) {
      Values start = origin;
      start[i] += away;
      if (!model(start)) continue;
      LeastSquares other = gauss_newton(model, target, all, std::move(start), 1e-4);
      if (other.sum_of_squares < best.sum_of_squares) best = std::move(other);
    }
  return best;
}

}  // namespace

FitData fit_data(const Grid<double>& truth, int factor) {
  FitData data = fit_data(truth, decimated(truth.view(), factor), factor);
  data.coarse_is_given = false;
  return data;
}

FitData fit_data(const Grid<double>& truth, const Grid<double>& coarse, int factor) {
  if (factor < 2) throw InvalidField("a fit needs a factor of at least 2");
  const auto given = [&](Index fine, Index n) { return std::min(n, (fine - 1) / factor + 1); };
  const Extent extent{given(truth.rows(), coarse.rows()), given(truth.cols(), coarse.cols())};
  if (extent.rows < 1 || extent.cols < 1) throw InvalidField("a fit needs a field with samples");
  FitData data;
  data.factor = factor;
  data.coarse_is_given = true;
  data.coarse = part(coarse, extent);
  data.truth = part(truth, {factor * (extent.rows - 1) + 1, factor * (extent.cols - 1) + 1});
  return data;
}

void check(const FitData& data) {
  const auto fits = [&](Index fine, Index coarse) {
    return fine == data.factor * (coarse - 1) + 1;
  };
  if (!fits(data.truth.rows(), data.coarse.rows()) || !fits(data.truth.cols(), data.coarse.cols()))
    throw InvalidField("the coarse field does not fit truth and factor; make them with fit_data()");
  const auto counts = held_out(data);
  if (std::count(counts.begin(), counts.end(), 1) < 100)
    throw InvalidField(
        "fewer than 100 samples are held out, too few to fit anything; give a larger raster or a "
        "smaller factor or margin");
}

std::vector<char> held_out(const FitData& data) {
  const Grid<double>& truth = data.truth;
  const Index rim = data.margin * data.factor;
  std::vector<char> counts(truth.samples().size(), 0);
  for (Index r = rim; r < truth.rows() - rim; ++r)
    for (Index c = rim; c < truth.cols() - rim; ++c) {
      const bool given = !data.coarse_is_given && r % data.factor == 0 && c % data.factor == 0;
      if (!given && std::isfinite(truth(r, c)))
        counts[static_cast<std::size_t>(r * truth.cols() + c)] = 1;
    }
  return counts;
}

int fold_of(const FitData& data, Index row, Index col) {
  const Index block = std::max<Index>(1, std::max(data.truth.rows(), data.truth.cols()) / 8);
  return static_cast<int>((row / block + 2 * (col / block)) % data.folds);
}

SchemeFit fit_scheme(const FitData& data, const ParameterSpace& space, Prediction mode,
                     FitCriterion criterion, const FitProgress& progress) {
  check(data);
  const Values origin(static_cast<std::size_t>(space.dimension()), 0.0);
  const auto predicted = [&](const Scheme& scheme) {
    return predict(data.coarse.view(), scheme, data.factor, mode, data.threads);
  };
  std::vector<char> counts = held_out(data);
  drop_missing(data, predicted(space.at(origin)), counts);
  // Roughly ten steps in all for the fit, three for each part of the cross-validation.
  const double expected = (10.0 + (criterion == FitCriterion::rmse ? 3.0 * data.folds : 0)) *
                          (2.0 * space.dimension() + 1);
  double evaluated = 0;
  const auto guarded = [&](const auto& values_of) -> Model {
    return [&, values_of](const Values& u) -> std::optional<Values> {
      if (progress) progress(std::min(0.99, ++evaluated / expected));
      try {
        return values_of(predicted(space.at(u)));
      } catch (const InvalidScheme&) {
        return std::nullopt;
      } catch (const InvalidField&) {
        return std::nullopt;
      }
    };
  };
  const Model heights =
      guarded([&](const Grid<double>& p) { return heights_model(data, counts, p); });
  const Values truth = heights_model(data, counts, data.truth);

  LeastSquares best;
  if (criterion == FitCriterion::roughness) {
    const Values target = spectrum_model(data, data.truth.view());
    if (target.size() < 3)
      throw InvalidField("the raster is too small for a spectrum; fit by RMSE instead");
    const Model spectrum =
        guarded([&](const Grid<double>& p) { return spectrum_model(data, p.view()); });
    best = from_many_starts(spectrum, target, origin);
  } else {
    best = gauss_newton(heights, truth, counts, origin);
  }
  SchemeFit fit{space.at(best.parameters), mode};
  fit.steps = best.steps;
  fit.converged = best.converged;
  const auto squares_of = [&](const Values& values, const std::vector<char>& which) {
    double sum = 0;
    for (std::size_t i = 0; i < which.size(); ++i)
      if (which[i] != 0) sum += (values[i] - truth[i]) * (values[i] - truth[i]);
    return sum;
  };
  fit.rmse = root_mean(squares_of(heights(best.parameters).value(), counts), counts);
  fit.cross_validated_rmse = std::numeric_limits<double>::quiet_NaN();
  if (criterion == FitCriterion::roughness || data.folds < 2) return fit;

  double left_out = 0;
  for (int fold = 0; fold < data.folds; ++fold) {
    std::vector<char> training = counts;
    std::vector<char> test = counts;
    for (Index r = 0; r < data.truth.rows(); ++r)
      for (Index c = 0; c < data.truth.cols(); ++c) {
        const auto i = static_cast<std::size_t>(r * data.truth.cols() + c);
        (fold_of(data, r, c) == fold ? training : test)[i] = 0;
      }
    const LeastSquares part = gauss_newton(heights, truth, training, best.parameters);
    left_out += squares_of(heights(part.parameters).value(), test);
  }
  fit.cross_validated_rmse = root_mean(left_out, counts);
  return fit;
}

}  // namespace arete

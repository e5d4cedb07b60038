// SPDX-License-Identifier: MIT
// arete fit: the member of a family that best predicts held-out samples of terrain, beside what
// others predict.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iomanip>
#include <iostream>
#include <limits>
#include <memory>
#include <sstream>

#include "arete/analysis/polynomial.h"
#include "arete/fit/fit_scheme.h"
#include "arete/gdal/band_source.h"
#include "arete/gdal/resample.h"
#include "arete/metrics/difference.h"
#include "arete/metrics/spectrum.h"
#include "cli/common_lattice.h"
#include "cli/error.h"
#include "cli/find_band.h"
#include "cli/json_number.h"
#include "cli/memory_size.h"
#include "cli/progress.h"
#include "cli/text_cells.h"
#include "cli/verb.h"

namespace arete::cli {
namespace {

struct FitArguments {
  std::string truth;
  std::string scheme;
  int factor = 2;
  std::string free;
  std::string criterion = "rmse";
  std::string mode = "best";
  std::string coarse;
  int band = 1;
  int folds = 5;
  int margin = 4;
  int threads = 0;
  std::string max_memory;
  bool json = false;
};

// One way to predict, and how well it does.
struct Row {
  std::string name;
  double rmse = 0;
  double largest = 0;
  double slope_rmse = 0;
  std::optional<SpectralSlope> spectrum;
  double cross_validated = std::numeric_limits<double>::quiet_NaN();
  std::string why_not;  ///< empty unless it could not predict
};

FitData read_data(const FitArguments& a, const gdal::Raster& truth) {
  const double memory = a.max_memory.empty() ? default_memory() : parse_memory_size(a.max_memory);
  const double samples =
      static_cast<double>(truth.extent().rows) * static_cast<double>(truth.extent().cols);
  // Truth, predictions and their derivatives, marks.
  check_memory("fitting to " + a.truth + " (cut out a part with gdal_translate -srcwin)",
               120 * samples, memory);
  const Grid<double> heights = gdal::read_band<double>(truth, find_band(truth, a.band));
  FitData data;
  if (a.coarse.empty()) {
    data = fit_data(heights, a.factor);
  } else {
    const gdal::Raster coarse(a.coarse);
    const LatticeMatch match = match_lattices(coarse, truth);
    if (!match.second_is_finer || match.row_step != a.factor || match.col_step != a.factor ||
        match.first_row != 0 || match.first_col != 0)
      throw Failure(a.coarse + ": every --factor-th sample of " + a.truth +
                    " must be one of its samples, from the first on; check --factor and its place");
    data = fit_data(heights, gdal::read_band<double>(coarse, find_band(coarse, a.band)), a.factor);
  }
  data.margin = a.margin;
  data.folds = a.folds;
  data.threads = a.threads;
  check(data);
  return data;
}

// The table: every prediction measured over the same samples.
class Table {
 public:
  Table(const FitData& data, WorldPoint spacing)
      : data_(data), spacing_(spacing), counts_(held_out(data)) {}

  template <class Predict>
  void add(const std::string& name, const Predict& predict,
           double cross_validated = std::numeric_limits<double>::quiet_NaN()) {
    Row row;
    row.name = name;
    row.cross_validated = cross_validated;
    try {
      measure(predict(), row);
    } catch (const InvalidScheme& error) {
      row.why_not = error.what();
    } catch (const InvalidField& error) {
      row.why_not = error.what();
    }
    rows_.push_back(std::move(row));
  }

  void add_scheme(const std::string& name, const Scheme& scheme, Prediction mode,
                  double cross_validated = std::numeric_limits<double>::quiet_NaN()) {
    add(
        name,
        [&] { return predict(data_.coarse.view(), scheme, data_.factor, mode, data_.threads); },
        cross_validated);
  }

  [[nodiscard]] std::vector<Row> sorted() const {
    std::vector<Row> rows = rows_;
    std::stable_sort(rows.begin(), rows.end(), [](const Row& x, const Row& y) {
      return x.why_not.empty() != y.why_not.empty() ? x.why_not.empty() : x.rmse < y.rmse;
    });
    return rows;
  }

 private:
  void measure(const Grid<double>& predicted, Row& row) const {
    // Only what counts is compared; slopes and spectra are taken of the whole inner field.
    const Extent extent = data_.truth.extent();
    Grid<double> truth(extent, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t i = 0; i < counts_.size(); ++i)
      if (counts_[i] != 0) truth.samples()[i] = data_.truth.samples()[i];
    const HeightDifference heights = compare_heights(truth.view(), predicted.view());
    row.rmse = heights.rmse;
    row.largest = heights.largest;
    const Index rim = data_.margin * data_.factor;
    const auto inner = [&](const Grid<double>& z) {
      return GridView<const double>(z.row(rim) + rim,
                                    {extent.rows - 2 * rim, extent.cols - 2 * rim}, extent.cols);
    };
    const auto a = inner(data_.truth);
    const auto b = inner(predicted);
    row.slope_rmse = compare_slopes(a, b, spacing_).rmse;
    row.spectrum = spectral_slope(profile_spectrum(b), 0.25 / data_.factor, 0.5);
  }

  const FitData& data_;
  WorldPoint spacing_;
  std::vector<char> counts_;
  std::vector<Row> rows_;
};

struct FitOutcome {
  std::optional<SchemeFit> direct, interpolating;
  std::string no_interpolation;  ///< why not
  std::vector<Row> rows;
  std::optional<SpectralSlope> truth_spectrum;

  // The better of both by what was not seen while fitting, where that was asked for.
  [[nodiscard]] const SchemeFit& best() const {
    if (!direct) return *interpolating;
    if (!interpolating) return *direct;
    const auto merit = [](const SchemeFit& fit) {
      return std::isnan(fit.cross_validated_rmse) ? fit.rmse : fit.cross_validated_rmse;
    };
    return merit(*interpolating) < merit(*direct) ? *interpolating : *direct;
  }
};

FitOutcome fit_and_compare(const FitArguments& a, const Scheme& scheme, const FitData& data,
                           const ParameterSpace& space, WorldPoint spacing) {
  const auto criterion = a.criterion == "rmse" ? FitCriterion::rmse : FitCriterion::roughness;
  FitOutcome outcome;
  Table table(data, spacing);
  ProgressBar progress("fitting");
  const auto fitted = [&](Prediction mode, double from, double to) {
    return fit_scheme(data, space, mode, criterion,
                      [&](double share) { progress.show(from + (to - from) * share); });
  };
  if (a.mode != "interpolating") outcome.direct = fitted(Prediction::direct, 0, 0.4);
  // What interpolates already has only one mode.
  const bool interpolates = outcome.direct && is_interpolatory(outcome.direct->scheme.mask());
  if (a.mode != "direct" && !interpolates) {
    try {
      outcome.interpolating = fitted(Prediction::interpolating, 0.4, 0.8);
    } catch (const InvalidScheme& error) {
      outcome.no_interpolation = error.what();
    } catch (const InvalidField& error) {
      outcome.no_interpolation = error.what();
    }
    if (!outcome.interpolating && a.mode == "interpolating")
      throw Failure("nothing to interpolate with: " + outcome.no_interpolation);
  }
  table.add_scheme(scheme.text() + " (as given)", scheme, Prediction::direct);
  const auto add_fit = [&](const std::optional<SchemeFit>& fit, const std::string& kind) {
    if (fit)
      table.add_scheme(scheme.name() + " fitted" + kind, fit->scheme, fit->mode,
                       fit->cross_validated_rmse);
  };
  add_fit(outcome.direct, "");
  add_fit(outcome.interpolating, ", interpolating");
  for (const char* text : {"b-spline:degree=3", "b-spline:degree=5"}) {
    const Scheme spline = parse_scheme(text);
    table.add(std::string(text) + ", interpolating", [&] {
      return predict(data.coarse.view(), spline, data.factor, Prediction::interpolating,
                     data.threads);
    });
  }
  for (const char* text : {"four-point:omega=1/16", "dubuc-deslauriers:points=6"})
    if (!(scheme.mask() == parse_scheme(text).mask()))
      table.add_scheme(text, parse_scheme(text), Prediction::direct);
  progress.show(0.9);
  for (const char* kernel : {"bilinear", "cubic", "cubicspline", "lanczos"})
    table.add(std::string("gdalwarp -r ") + kernel,
              [&] { return gdal::resampled(data.coarse.view(), kernel, data.factor); });
  outcome.rows = table.sorted();
  outcome.truth_spectrum =
      spectral_slope(profile_spectrum(data.truth.view()), 0.25 / data.factor, 0.5);
  return outcome;
}

// The scheme's text with decimals where they are exact, which most readers prefer to twelve-digit
// fractions.
std::string decimal_text(const Scheme& scheme) {
  std::string text;
  for (const ParameterValue& value : scheme.parameters()) {
    text += (text.empty() ? ":" : ",") + value.name + "=";
    for (std::size_t i = 0; i < value.numbers.size(); ++i) {
      std::ostringstream decimal;
      decimal << std::setprecision(15) << to_double(value.numbers[i]);
      const bool exact = parse_rational(decimal.str()) == value.numbers[i];
      text += (i == 0 ? "" : ";") + (exact ? decimal.str() : to_string(value.numbers[i]));
    }
  }
  return scheme.name() + text;
}

Json fit_json(const SchemeFit& fit) {
  return {{"scheme", decimal_text(fit.scheme)},
          {"interpolating", fit.mode == Prediction::interpolating},
          {"rmse", fit.rmse},
          {"cross_validated_rmse", number_or_null(fit.cross_validated_rmse)},
          {"steps", fit.steps},
          {"converged", fit.converged}};
}

void print_json(const FitArguments& a, const ParameterSpace& space, const FitOutcome& outcome,
                Index samples, double seconds) {
  Json rows = Json::array();
  for (const Row& row : outcome.rows)
    rows.push_back(
        {{"method", row.name},
         {"rmse", row.why_not.empty() ? number_or_null(row.rmse) : Json(nullptr)},
         {"max", row.why_not.empty() ? number_or_null(row.largest) : Json(nullptr)},
         {"slope_rmse", row.why_not.empty() ? number_or_null(row.slope_rmse) : Json(nullptr)},
         {"spectral_slope", slope_or_null(row.spectrum)},
         {"cross_validated_rmse", number_or_null(row.cross_validated)}});
  Json object = fit_json(outcome.best());
  object["truth"] = a.truth;
  object["factor"] = a.factor;
  object["criterion"] = a.criterion;
  object["free"] = space.free_names();
  object["held_out"] = samples;
  object["fits"] = Json::array();
  for (const auto* fit : {&outcome.direct, &outcome.interpolating})
    if (*fit) object["fits"].push_back(fit_json(**fit));
  object["truth_spectral_slope"] = slope_or_null(outcome.truth_spectrum);
  object["rows"] = std::move(rows);
  object["seconds"] = seconds;
  std::cout << object.dump(2) << '\n';
}

void print_text(const FitArguments& a, const ParameterSpace& space, const FitOutcome& outcome,
                Index samples, double seconds) {
  std::size_t width = 6;
  for (const Row& row : outcome.rows) width = std::max(width, row.name.size());
  std::ostringstream text;
  text << std::fixed;
  const auto cell = [&](double value, int digits) {
    if (std::isfinite(value))
      text << std::setw(11) << std::setprecision(digits) << value;
    else
      text << std::setw(11) << "-";
  };
  const auto slope = [](const std::optional<SpectralSlope>& s) {
    return s ? s->slope : std::numeric_limits<double>::quiet_NaN();
  };
  text << a.truth << ": one of " << a.factor << " samples along both axes given, " << samples
       << " others predicted\n\n"
       << std::left << std::setw(static_cast<int>(width)) << "method" << std::right << std::setw(11)
       << "RMSE" << std::setw(11) << "cross-val." << std::setw(11) << "largest" << std::setw(11)
       << "slope RMSE" << std::setw(11) << "spectrum" << '\n';
  for (const Row& row : outcome.rows) {
    text << std::left << std::setw(static_cast<int>(width)) << row.name << std::right;
    if (!row.why_not.empty()) {
      text << "  none: " << row.why_not << '\n';
      continue;
    }
    cell(row.rmse, 4);
    cell(row.cross_validated, 4);
    cell(row.largest, 2);
    cell(row.slope_rmse, 3);
    cell(slope(row.spectrum), 2);
    text << '\n';
  }
  text << std::left << std::setw(static_cast<int>(width)) << "(truth)" << std::right
       << std::setw(44) << "";
  cell(slope(outcome.truth_spectrum), 2);
  std::string free;
  for (const std::string& name : space.free_names()) free += (free.empty() ? "" : ", ") + name;
  text << "\n\n"
       << "fitted " << free << " by " << a.criterion << " in " << std::setprecision(2) << seconds
       << " s:\n  " << decimal_text(outcome.best().scheme)
       << (outcome.best().mode == Prediction::interpolating ? "   (interpolating)" : "") << '\n';
  const Row& first = outcome.rows.front();
  text << "lowest RMSE: " << first.name;
  std::string ties;
  for (std::size_t i = 1; i < outcome.rows.size(); ++i)
    if (outcome.rows[i].why_not.empty() && outcome.rows[i].rmse <= 1.01 * first.rmse)
      ties += (ties.empty() ? "" : "; ") + outcome.rows[i].name;
  if (!ties.empty()) text << "; within 1 % of it: " << ties;
  text << '\n';
  if (!outcome.best().converged)
    text << "note: the fit had not settled after " << outcome.best().steps << " steps\n";
  std::cout << text.str();
}

void fit(const FitArguments& a) {
  const auto start = std::chrono::steady_clock::now();
  const Scheme scheme = read_scheme(a.scheme);
  std::vector<std::string> names;
  if (!a.free.empty()) names = cells_of(a.free, ",");
  const ParameterSpace space(scheme, names);
  const gdal::Raster truth(a.truth);
  const FitData data = read_data(a, truth);
  const auto counts = held_out(data);
  const FitOutcome outcome = fit_and_compare(
      a, scheme, data, space, ground_spacing(truth.place(), truth.extent(), truth.geographic()));
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const auto samples = static_cast<Index>(std::count(counts.begin(), counts.end(), 1));
  if (a.json)
    print_json(a, space, outcome, samples, seconds);
  else
    print_text(a, space, outcome, samples, seconds);
}

}  // namespace

void add_fit(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "fit", "Find the parameters of a family that best predict held-out samples of terrain");
  auto a = std::make_shared<FitArguments>();
  verb->add_option("TRUTH", a->truth, "Any raster that GDAL reads")->required();
  verb->add_option("--scheme", a->scheme,
                   "The family and where to start, e.g. four-parameter or four-point:omega=0.1")
      ->required();
  verb->add_option("--factor", a->factor,
                   "Every how many-th sample is given: the scheme's arity or a power of it")
      ->check(CLI::Range(2, 729))
      ->capture_default_str();
  verb->add_option(
      "--free", a->free,
      "Parameters to fit, e.g. lambda,omega (default: all in which the mask is linear; "
      "tau and the reproduction of planes are kept)");
  verb->add_option("--criterion", a->criterion,
                   "rmse: held-out heights; roughness: the spectrum of the new octaves")
      ->check(CLI::IsMember({"rmse", "roughness"}))
      ->capture_default_str();
  verb->add_option("--mode", a->mode,
                   "direct: samples as control points; interpolating: the limit through the "
                   "samples; best: both, the better one is named")
      ->check(CLI::IsMember({"best", "direct", "interpolating"}))
      ->capture_default_str();
  verb->add_option(
      "--coarse", a->coarse,
      "The given samples as a raster of their own (default: every factor-th of TRUTH)");
  verb->add_option("--folds", a->folds, "Parts of the cross-validation over blocks of terrain")
      ->check(CLI::Range(2, 64))
      ->capture_default_str();
  verb->add_option("--margin", a->margin, "Coarse samples along the rim that do not count")
      ->check(CLI::Range(0, 1000))
      ->capture_default_str();
  verb->add_option("--band", a->band, "Which band holds the heights")->capture_default_str();
  verb->add_option("--threads", a->threads, "0: as many as the machine has; never changes a bit")
      ->check(CLI::Range(0, 4096))
      ->capture_default_str();
  verb->add_option("--max-memory", a->max_memory,
                   "Memory to hold at most, e.g. 800M (default: half of the machine's)");
  verb->add_flag("--json", a->json, "Print one JSON object");
  verb->callback([&job, a] { job = [a] { fit(*a); }; });
}

}  // namespace arete::cli

// SPDX-License-Identifier: MIT
// arete ifs: curves as attractors of iterated function systems.
#include <algorithm>
#include <iostream>
#include <memory>

#include "arete/fractal/chaos_game.h"
#include "arete/fractal/contraction.h"
#include "arete/fractal/curve_system.h"
#include "arete/fractal/goldman.h"
#include "arete/fractal/ifs.h"
#include "cli/curve_output.h"
#include "cli/error.h"
#include "cli/interruption.h"
#include "cli/output_file.h"
#include "cli/point_stream.h"
#include "cli/progress.h"
#include "cli/scheme_json.h"
#include "cli/verb.h"
#ifdef ARETE_HAVE_VTK
#include "cli/scatter_picture.h"
#endif

namespace arete::cli {
namespace {

struct IfsArguments {
  std::string system;
  std::string control;
  std::string output;
  int depth = 8;
  bool closed = false;
  bool on_curve = false;
  long long chaos = 0;
  std::uint64_t seed = 1;
  bool overwrite = false;
  bool json = false;
};

/// A curve made of arcs, and how to start.
struct Attractor {
  CurveSystem system;
  MatrixSet<double> set;
  std::vector<Matrix<double>> arcs;
  Matrix<double> seed;
  long long points = 0;
};

Matrix<double> matrix_of(const Grid<double>& grid) {
  Matrix<double> result(static_cast<int>(grid.rows()), static_cast<int>(grid.cols()));
  for (int r = 0; r < result.rows(); ++r)
    for (int c = 0; c < result.cols(); ++c) result(r, c) = grid(r, c);
  return result;
}

// The starts of the arcs of the limit instead of their first control points.
Matrix<double> seed_of(const CurveSystem& system, bool on_curve) {
  if (!on_curve) return first_point_seed<double>(system.set.size());
  const auto row = fixed_row(system.set[0]);
  if (!row)
    throw Misuse("--on-curve: the arcs of " + system.text +
                 " do not determine where they start; leave it out");
  Matrix<double> seed(1, system.set.size());
  for (int i = 0; i < seed.cols(); ++i) seed(0, i) = to_double((*row)[static_cast<std::size_t>(i)]);
  return seed;
}

Attractor attractor_of(const IfsArguments& a, const Points& control) {
  constexpr Index most = 1 << 24;
  if (control.values.rows() > most)
    throw Failure(a.control + " has more than 2^24 points; give a shorter polygon");
  Attractor result;
  result.system = parse_curve_system(a.system, static_cast<int>(control.values.rows()));
  check_maps(result.system.set);
  result.set = to_double(result.system.set);
  result.arcs = cut_into_arcs(result.system, matrix_of(control.values), a.closed);
  result.seed = seed_of(result.system, a.on_curve);
  const long long each = Ifs<double>(result.set, result.arcs.front()).count(a.depth);
  result.points = each * static_cast<long long>(result.arcs.size());
  return result;
}

// visit(point) for all points in the order of the curve, by the deterministic algorithm.
template <class Visit>
void visit_all(const Attractor& attractor, int depth, Visit&& visit) {
  ProgressBar progress("iterating");
  long long done = 0;
  for (const Matrix<double>& arc : attractor.arcs)
    Ifs<double>(attractor.set, arc)
        .visit_points(depth, attractor.seed, [&](const std::vector<double>& point) {
          visit(point);
          if (++done % 4096 == 0)
            progress.show(static_cast<double>(done) / static_cast<double>(attractor.points));
        });
}

void write_deterministic(const IfsArguments& a, const Attractor& attractor, const Points& control,
                         const std::filesystem::path& path) {
  if (path.extension() == ".csv") {
    PointStream stream(path, control.header);
    visit_all(attractor, a.depth,
              [&stream](const std::vector<double>& point) { stream.write(point); });
    stream.close();
    return;
  }
  constexpr long long most = 1LL << 24;
  if (attractor.points > most)
    throw Failure("a line of " + std::to_string(attractor.points) + " points is too long for " +
                  a.output + "; use less depth, or write a .csv");
  const bool closed = a.closed || attractor.system.contour;
  CurveFile curve{Grid<double>({static_cast<Index>(attractor.points), control.values.cols()}),
                  {},
                  closed,
                  {},
                  {},
                  control.values};
  Index row = 0;
  visit_all(attractor, a.depth, [&](const std::vector<double>& point) {
    std::copy(point.begin(), point.end(), curve.points.row(row++));
  });
  write_curve(curve, path);
}

#ifdef ARETE_HAVE_VTK
ScatterPicture empty_picture(const Attractor& attractor) {
  // The box of the attractor, seen at a small depth, and some air.
  std::vector<double> low, high;
  int depth = 0;
  for (long long count = 1; count < 256; count *= attractor.set.arity()) ++depth;
  for (const Matrix<double>& arc : attractor.arcs)
    Ifs<double>(attractor.set, arc)
        .visit_points(depth, attractor.seed, [&](const std::vector<double>& point) {
          if (low.empty()) low = high = point;
          for (std::size_t c = 0; c < point.size(); ++c) {
            low[c] = std::min(low[c], point[c]);
            high[c] = std::max(high[c], point[c]);
          }
        });
  return {low, high};
}
#endif

void write_chaos(const IfsArguments& a, const Attractor& attractor, const Points& control,
                 const std::filesystem::path& path) {
  ChaosGame game(attractor.set, attractor.arcs, a.seed);
  ProgressBar progress("playing");
  const auto play = [&](auto&& visit) {
    for (long long i = 0; i < a.chaos; ++i) {
      visit(game.next());
      if (i % 4096 == 0) progress.show(static_cast<double>(i) / static_cast<double>(a.chaos));
    }
  };
  if (path.extension() == ".csv") {
    PointStream stream(path, control.header);
    play([&stream](const std::vector<double>& point) { stream.write(point); });
    stream.close();
    return;
  }
#ifdef ARETE_HAVE_VTK
  if (control.values.cols() < 2)
    throw InvalidField("a picture needs points of two coordinates or more");
  ScatterPicture picture = empty_picture(attractor);
  play([&picture](const std::vector<double>& point) { picture.add(point); });
  picture.write(path);
#endif
}

Json matrix_json(const Matrix<Rational>& a) {
  Json rows = Json::array();
  for (int i = 0; i < a.rows(); ++i) {
    Json row = Json::array();
    for (int j = 0; j < a.cols(); ++j) row.push_back(to_double(a(i, j)));
    rows.push_back(std::move(row));
  }
  return rows;
}

Json contraction_json(const CurveSystem& system) {
  int power = 0;  // as many products as are quick to look through
  for (long long products = system.set.arity(); products <= 4096 && power < 8;
       products *= system.set.arity())
    ++power;
  const auto contraction = find_contraction(system.set, std::max(power, 1));
  if (!contraction) return nullptr;
  return {{"power", contraction->power}, {"coefficient", to_string(contraction->coefficient)}};
}

// The affine maps of every arc, up to a number that can be looked at.
Json maps_json(const Attractor& attractor) {
  constexpr std::size_t most_arcs = 100;
  if (attractor.arcs.size() > most_arcs) return nullptr;
  Json all = Json::array();
  for (const Matrix<double>& arc : attractor.arcs) {
    Matrix<Rational> exact(arc.rows(), arc.cols());
    for (int r = 0; r < arc.rows(); ++r)
      for (int c = 0; c < arc.cols(); ++c) exact(r, c) = Rational(arc(r, c));
    const auto goldman = goldman_maps(attractor.system.set, exact);
    if (!goldman) {
      all.push_back(nullptr);
      continue;
    }
    Json maps = Json::array();
    for (const Matrix<Rational>& map : goldman->maps) maps.push_back(matrix_json(map));
    all.push_back(std::move(maps));
  }
  return all;
}

void report(const IfsArguments& a, const Attractor& attractor) {
  const long long points = a.chaos > 0 ? a.chaos : attractor.points;
  if (a.json) {
    Json object{{"control", a.control},
                {"output", a.output},
                {"system", attractor.system.text},
                {"arcs", attractor.arcs.size()},
                {"maps_per_arc", attractor.set.arity()}};
    if (a.chaos > 0)
      object["seed"] = a.seed;
    else
      object["depth"] = a.depth;
    object["points"] = points;
    object["contraction"] = contraction_json(attractor.system);
    object["goldman_maps"] = maps_json(attractor);
    std::cout << object.dump(2) << '\n';
    return;
  }
  std::cout << a.control << " -> " << a.output << " (" << points
            << " points): " << attractor.system.text << ", " << attractor.arcs.size()
            << (attractor.arcs.size() == 1 ? " arc of " : " arcs of ") << attractor.set.arity()
            << " maps, "
            << (a.chaos > 0 ? "chaos game, seed " + std::to_string(a.seed)
                            : "depth " + std::to_string(a.depth))
            << '\n';
}

void run_ifs(const IfsArguments& a) {
  check_curve_form(a.output);
  if (a.chaos > 0 && std::filesystem::path(a.output).extension() == ".vtp")
    throw Misuse(a.output + ": the points of a chaos game are no line; write a .csv or .png");
  const Points control = read_points(a.control);
  const Attractor attractor = attractor_of(a, control);
  OutputFile output(a.output, a.control, a.overwrite);
  if (a.chaos > 0)
    write_chaos(a, attractor, control, output.temporary());
  else
    write_deterministic(a, attractor, control, output.temporary());
  stop_if_interrupted();
  output.commit();
  report(a, attractor);
}

}  // namespace

void add_ifs(CLI::App& program, Job& job) {
  CLI::App* verb = program.add_subcommand(
      "ifs",
      "Curves and fractals as attractors of matrices: points (.csv), a .vtp or a plot (.png)");
  auto a = std::make_shared<IfsArguments>();
  verb->add_option("SYSTEM", a->system,
                   "bezier, bezier:degree=D, perturbed-bezier, natural-spline, contour, or any "
                   "scheme, e.g. de-rham")
      ->required();
  verb->add_option("OUT", a->output, "The format follows the extension: .csv, .vtp, .png")
      ->required();
  verb->add_option("--control", a->control, "Control points, one a line")->required();
  verb->add_option("--depth", a->depth, "Every arc gives (maps)^depth points")
      ->capture_default_str();
  verb->add_flag("--closed", a->closed, "The last control point joins the first");
  verb->add_flag("--on-curve", a->on_curve,
                 "Points on the attractor itself rather than control points of its arcs");
  verb->add_option("--chaos", a->chaos, "Play the chaos game for so many points instead")
      ->check(CLI::Range(1LL, 1LL << 40));
  verb->add_option("--seed", a->seed, "Of the chaos game: the same seed, the same points")
      ->capture_default_str();
  verb->add_flag("--overwrite", a->overwrite, "Replace OUT if it exists");
  verb->add_flag("--json", a->json, "Print one JSON object about what was done");
  verb->callback([&job, a] { job = [a] { run_ifs(*a); }; });
}

}  // namespace arete::cli

// SPDX-License-Identifier: MIT
// The steps of docs/cpp.md, one function each; every step checks what it says.
#include <arete/analysis/limit_stencil.h>
#include <arete/analysis/smoothness.h>
#include <arete/field/error.h>
#include <arete/refine/curve.h>
#include <arete/refine/refiner.h>
#include <arete/reverse/grid_reverse.h>
#include <arete/scheme/catalogue.h>
#include <arete/scheme/error.h>

#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>

namespace {

arete::Grid<float> hill() {
  arete::Grid<float> coarse({9, 9});
  coarse(4, 4) = 100;
  return coarse;
}

bool refine() {
  const arete::Scheme scheme = arete::parse_scheme("gentle");
  arete::RefineOptions options;
  options.levels = 3;
  options.boundaries = {arete::Boundary::reflect, arete::Boundary::clamp};  // along x, along y
  options.threads = 0;                                                      // all; same bits
  const arete::Refiner<float> refiner(scheme, {9, 9}, options);  // plans once, for many grids
  const arete::Grid<float> fine = refiner(hill().view());
  return fine.extent() == refiner.output() && fine.cols() == 65;
}

bool stream() {
  const arete::Grid<float> coarse = hill();
  const arete::Refiner<float> refiner(arete::parse_scheme("craggy"), coarse.extent(),
                                      {.levels = 6});
  float highest = -std::numeric_limits<float>::infinity();
  refiner.for_each_tile(arete::GridSource<float>(coarse.view()), {0, refiner.output().rows - 1},
                        [&](arete::Index, arete::Index, arete::GridView<const float> tile) {
                          for (arete::Index r = 0; r < tile.rows(); ++r)
                            for (arete::Index c = 0; c < tile.cols(); ++c)
                              highest = std::fmax(highest, tile(r, c));
                        });
  return highest > 0 && highest <= 200;
}

bool holes() {
  arete::Grid<float> coarse = hill();
  coarse(0, 0) = std::numeric_limits<float>::quiet_NaN();
  const arete::Grid<float> fine =
      arete::refine(coarse, arete::parse_scheme("four-point"), {.levels = 1});
  // The cell beside the hole stays empty, the next begins with its own sample.
  return std::isnan(fine(0, 0)) && std::isnan(fine(1, 1)) && fine(2, 2) == coarse(1, 1);
}

bool polyline() {
  arete::Grid<double> square({4, 2});  // one point a row, one coordinate a column
  square.samples() = {0, 0, 8, 0, 8, 8, 0, 8};
  const auto rounded = arete::refine_curve<double>(square.view(), arete::parse_scheme("chaikin"),
                                                   {.levels = 1, .closed = true});
  return rounded.points.rows() == 8;
}

bool prove() {
  const arete::Scheme scheme = arete::parse_scheme("four-point:omega=1/16");
  const arete::Smoothness proof = arete::analyze_smoothness(scheme.mask());
  std::cout << scheme.text() << " " << arete::coefficients_text(scheme.mask()) << " is C^"
            << proof.certified << ", exponent " << proof.hoelder.lower << "\n";
  return proof.certified == 1 && proof.refuted_at == 2 && proof.hoelder.lower == 2;
}

bool own_mask() {
  using arete::Rational;
  const arete::Mask mask(2, -1, {Rational(1) / 2, Rational(1), Rational(1) / 2});  // from a_-1 on
  const arete::Scheme linear = arete::make_scheme(
      "mask", {{"arity", {2}}, {"first", {-1}}, {"coefficients", mask.coefficients()}});
  return linear == arete::parse_scheme("mask:arity=2,first=-1,coefficients=1/2;1;1/2") &&
         arete::analyze_smoothness(mask).certified == 0;
}

bool there_and_back() {
  const arete::Scheme scheme = arete::parse_scheme("b-spline:degree=3");
  const arete::Grid<double> fine =
      arete::refine(arete::Grid<double>({9, 9}, 3.0), scheme, {.levels = 2});
  arete::GridReverseOptions options;
  options.levels = 2;
  const auto parts = arete::decompose_grid<double>(fine.view(), scheme, options);
  const arete::Grid<double> again =
      arete::reconstruct_grid(parts, fine.extent(), scheme, options, options.levels);
  return parts.coarse.extent() == arete::Extent{9, 9} && std::abs(again(7, 5) - 3) < 1e-12;
}

bool refusal() {
  try {
    return arete::parse_scheme("four-point:omega=much").name().empty();
  } catch (const arete::InvalidScheme& error) {
    std::cerr << error.what() << "\n";
    return true;
  }
}

}  // namespace

int main() {
  struct Step {
    const char* name;
    bool (*run)();
  };
  for (const Step& step :
       {Step{"refine", refine}, Step{"stream", stream}, Step{"holes", holes},
        Step{"polyline", polyline}, Step{"prove", prove}, Step{"own mask", own_mask},
        Step{"there and back", there_and_back}, Step{"refusal", refusal}}) {
    if (step.run()) continue;
    std::printf("%s: not what docs/cpp.md says\n", step.name);
    return 1;
  }
  return 0;
}

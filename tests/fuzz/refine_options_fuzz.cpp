// SPDX-License-Identifier: MIT
// Any options of a refinement: plans of claimed sizes are refused or made without the samples
// there; small grids of any numbers are refused or refined, and rows in bands equal the whole.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "byte_reader.h"
#include "cli/error.h"
#include "cli/memory_size.h"
#include "cli/number_list.h"

namespace {

using namespace arete;

void parse_texts(const std::string& text) {
  try {
    if (!(cli::parse_memory_size(text) > 0)) std::abort();
  } catch (const cli::Misuse&) {
  }
  try {
    if (cli::parse_numbers(text, 'x', 2, 4, "it").size() > 4) std::abort();
  } catch (const cli::Misuse&) {
  }
}

void plan_claims(const Scheme& scheme, ByteReader bytes, Boundary boundary) {
  try {
    AxisOptions options;
    options.boundary = boundary;
    const auto count = bytes.take<std::int64_t>();
    options.levels = bytes.take<std::int32_t>();
    options.alignment = bytes.below(2) == 0 ? Alignment::nodes : Alignment::cells;
    const AxisPlan plan(scheme.mask(), count, options);
    if (plan.output_count() < 1 || plan.output_count() > (Index{1} << 40)) std::abort();
  } catch (const InvalidField&) {
  }
}

Stencil stencil_of(ByteReader& bytes) {
  Stencil stencil;
  stencil.first = bytes.take<std::int8_t>();
  for (int k = bytes.below(6); k >= 0; --k)
    stencil.weights.push_back(Rational(bytes.take<std::int8_t>(), 1 + bytes.below(16)));
  return stencil;
}

RefineOptions options_of(ByteReader& bytes, Boundaries boundaries) {
  RefineOptions options;
  options.boundaries = boundaries;
  options.levels = bytes.take<std::int8_t>() % 4;
  options.alignment = bytes.below(2) == 0 ? Alignment::nodes : Alignment::cells;
  const int extras = bytes.below(8);
  if ((extras & 1) != 0) options.final_x = stencil_of(bytes);
  if ((extras & 2) != 0) options.final_y = stencil_of(bytes);
  if ((extras & 4) != 0) {
    Detail detail;
    detail.roughness = bytes.take<double>();
    detail.relief = bytes.take<double>();
    detail.seed = bytes.take<std::uint64_t>();
    options.detail = detail;
  }
  return options;
}

void refine(const Scheme& scheme, ByteReader& bytes, Boundaries boundaries) {
  // Large masks and arities take time and show nothing more.
  if (scheme.mask().arity() > 5 || scheme.mask().coefficients().size() > 40) return;
  const RefineOptions options = options_of(bytes, boundaries);
  Grid<float> grid({1 + bytes.below(6), 1 + bytes.below(6)});
  for (float& sample : grid.samples()) sample = bytes.take<float>();
  const Refiner<float> refiner(scheme, grid.extent(), options);
  const Grid<float> whole = refiner(grid.view());
  const Index cut = whole.rows() / 2;
  Grid<float> lower({whole.rows() - cut, whole.cols()});
  refiner.refine_rows(GridSource<float>(grid.view()), cut, lower.view());
  if (std::memcmp(lower.row(0), whole.row(cut), lower.samples().size() * sizeof(float)) != 0)
    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  ByteReader bytes(data, size);
  const std::string scheme_text = bytes.line();
  const std::string boundary_text = bytes.line();
  parse_texts(bytes.line());
  try {
    const Boundaries boundaries = parse_boundaries(boundary_text);
    const Scheme scheme = parse_scheme(scheme_text);
    plan_claims(scheme, bytes, boundaries.x);
    refine(scheme, bytes, boundaries);
  } catch (const InvalidField&) {
  } catch (const InvalidScheme&) {
  }
  return 0;
}

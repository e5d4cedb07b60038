// SPDX-License-Identifier: MIT
// Google Benchmark of the engine: kernels, one level and several, heights and points, small to
// large. Every row says what share of the write limit of memory it reaches: the time to fill the
// same bytes past the cache, taken in the same process between its repetitions.
#include <benchmark/benchmark.h>

#include <string>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "measure.h"

namespace arete::bench {
namespace {

constexpr const char* masks[]{"four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7",
                              "b-spline:degree=3",
                              "four-point",
                              "chaikin",
                              "b-spline:degree=5",
                              "dubuc-deslauriers:points=8",
                              "ternary-four-point",
                              "ternary-two-step-9"};

int levels_of(const Scheme& scheme, int binary_levels) {
  const int arity = scheme.mask().arity();
  if (arity == 2) return binary_levels;
  return arity == 3 ? std::max(1, 2 * binary_levels / 3) : std::max(1, (binary_levels + 1) / 3);
}

void report(benchmark::State& state, double samples, Plane<float>& result) {
  const Index count = result.rows() * result.stride();
  std::vector<double> fills;
  for (int i = 0; i < 5; ++i) {
    const double start = cpu_seconds();
    fill_past_cache(result.row(0), count);
    fills.push_back(cpu_seconds() - start);
  }
  const double limit = static_cast<double>(count) / median(fills);
  state.counters["samples/s"] = benchmark::Counter(
      samples, benchmark::Counter::kIsIterationInvariantRate, benchmark::Counter::kIs1000);
  state.counters["of_write_limit"] =
      benchmark::Counter(samples / limit, benchmark::Counter::kIsIterationInvariantRate);
}

void refine_heights(benchmark::State& state) {
  const Scheme scheme = parse_scheme(masks[state.range(0)]);
  const Grid<float> input = terrain({state.range(1), state.range(1)});
  RefineOptions options;
  options.levels = levels_of(scheme, static_cast<int>(state.range(2)));
  const Refiner<float> refiner(scheme, input.extent(), options);
  const GridSource<float> source(input.view());
  Plane<float> result(refiner.output());
  for (auto _ : state) refiner.refine_rows(source, 0, result.view());
  state.SetLabel(scheme.text());
  report(state, static_cast<double>(result.rows()) * static_cast<double>(result.cols()), result);
}
BENCHMARK(refine_heights)
    ->ArgNames({"mask", "size", "levels"})
    ->ArgsProduct({benchmark::CreateDenseRange(0, 7, 1), {257}, {4}})
    ->ArgsProduct({{0, 1}, {65}, {1, 2, 3, 4, 5}})
    ->ArgsProduct({{0, 1}, {1025}, {1, 2, 3}})
    ->Unit(benchmark::kMillisecond);

void refine_points(benchmark::State& state) {
  const Scheme scheme = parse_scheme(masks[state.range(0)]);
  const Grid<float> input = terrain({257, 257});
  RefineOptions options;
  options.levels = 4;
  const Refiner<float> refiner(scheme, input.extent(), options);
  const GridSource<float> source(input.view());
  const Extent size = refiner.output();
  // x, y and z, one plane after the other.
  Plane<float> result({3 * size.rows, size.cols});
  for (auto _ : state)
    for (Index k = 0; k < 3; ++k)
      refiner.refine_rows(source, 0,
                          GridView<float>(result.row(k * size.rows), size, result.stride()));
  state.SetLabel(scheme.text());
  report(state, static_cast<double>(result.rows()) * static_cast<double>(result.cols()), result);
}
BENCHMARK(refine_points)->ArgNames({"mask"})->Arg(0)->Arg(1)->Unit(benchmark::kMillisecond);

// One row through one kernel; the write limit is far behind, so samples a second only.
void kernel_weave(benchmark::State& state) {
  const auto& sets = available_kernels<float>();
  const auto set = static_cast<std::size_t>(state.range(0));
  if (set >= sets.size()) return state.SkipWithError("this machine has no such kernels");
  constexpr Index turns = 1024;
  std::vector<float> line(turns + 2 * kernel_slack, 1.25F);
  const std::vector<float> weights{0.1F, 0.2F, 0.3F, 0.4F, 0.5F, 0.6F, 0.7F, 0.8F};
  Plane<float> out({1, 2 * turns});
  const Strand<float> strands[]{{0, weights.data(), static_cast<int>(state.range(1))},
                                {0, weights.data(), static_cast<int>(state.range(2))}};
  const int warp_taps = static_cast<int>(state.range(3));
  const Weave<float> weave = sets[set]->weave_for(warp_taps, strands, 2);
  const std::vector<const float*> lines(8, line.data());
  for (auto _ : state) {
    weave(out.row(0), {lines.data(), weights.data(), warp_taps}, strands, 2, 2 * turns, false);
    benchmark::ClobberMemory();
  }
  state.SetLabel(std::string(sets[set]->name));
  state.SetItemsProcessed(state.iterations() * 2 * turns);
}
BENCHMARK(kernel_weave)
    ->ArgNames({"set", "even", "odd", "warp"})
    ->ArgsProduct({{0, 1, 2}, {3}, {4}, {0, 3, 4}})
    ->ArgsProduct({{0, 1, 2}, {3}, {3}, {0, 3}})
    ->ArgsProduct({{0, 1, 2}, {7}, {7}, {0}});

void kernel_combine(benchmark::State& state) {
  const auto& sets = available_kernels<float>();
  const auto set = static_cast<std::size_t>(state.range(0));
  if (set >= sets.size()) return state.SkipWithError("this machine has no such kernels");
  constexpr Index count = 1024;
  const int taps = static_cast<int>(state.range(1));
  std::vector<std::vector<float>> rows(static_cast<std::size_t>(taps),
                                       std::vector<float>(count, 1.25F));
  std::vector<const float*> lines;
  for (const auto& row : rows) lines.push_back(row.data());
  const std::vector<float> weights(static_cast<std::size_t>(taps), 0.25F);
  Plane<float> out({1, count});
  for (auto _ : state) {
    sets[set]->combine(out.row(0), lines.data(), weights.data(), taps, count);
    benchmark::ClobberMemory();
  }
  state.SetLabel(std::string(sets[set]->name));
  state.SetItemsProcessed(state.iterations() * count);
}
BENCHMARK(kernel_combine)->ArgNames({"set", "taps"})->ArgsProduct({{0, 1, 2}, {2, 3, 4, 8}});

void copy_memory(benchmark::State& state) {
  Plane<float> from({1, Index{1} << 24}), to({1, Index{1} << 24});
  std::fill_n(from.row(0), from.cols(), 1.0F);
  for (auto _ : state) {
    std::copy_n(from.row(0), from.cols(), to.row(0));
    benchmark::ClobberMemory();
  }
  report(state, static_cast<double>(to.cols()), to);
}
BENCHMARK(copy_memory)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace arete::bench

BENCHMARK_MAIN();

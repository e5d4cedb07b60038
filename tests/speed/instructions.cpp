// SPDX-License-Identifier: MIT
// Does one small piece of the engine's work with one set of kernels, for callgrind to count:
//
//     speed_instructions CASE          e.g. weave-3-4/avx2; without CASE it lists them
//
// Everything but counted_work() is left out of the count.
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"

namespace {

using namespace arete;

constexpr Index row_samples = 1024;

const Kernels<float>& kernels_named(const std::string& name) {
  for (const Kernels<float>* kernels : available_kernels<float>())
    if (kernels->name == name) return *kernels;
  std::puts("this machine has no such kernels");
  std::exit(77);
}

using Work = std::function<void()>;

Work combine_row(const std::string& set, int taps) {
  const std::vector<std::vector<float>> rows(static_cast<std::size_t>(taps),
                                             std::vector<float>(row_samples, 1.25F));
  return [=, &kernels = kernels_named(set), out = std::vector<float>(row_samples)]() mutable {
    std::vector<const float*> lines;
    for (const auto& row : rows) lines.push_back(row.data());
    const std::vector<float> weights(rows.size(), 0.25F);
    kernels.combine(out.data(), lines.data(), weights.data(), static_cast<int>(rows.size()),
                    row_samples);
  };
}

// `phases`: first sample and taps of each phase.
Work weave_row(const std::string& set, const std::vector<std::pair<Index, int>>& phases) {
  const auto arity = static_cast<int>(phases.size());
  auto out = std::make_shared<Plane<float>>(Extent{1, row_samples * arity});
  return [=, &kernels = kernels_named(set),
          line = std::vector<float>(row_samples + 2 * kernel_slack, 1.25F)] {
    const std::vector<float> weights(16, 0.25F);
    const float* const start = line.data();
    std::vector<Strand<float>> strands;
    for (const auto& [first, taps] : phases) strands.push_back({first, weights.data(), taps});
    kernels.weave_for(0, strands.data(), arity)(out->row(0), {&start, nullptr, 0}, strands.data(),
                                                arity, arity * row_samples, false);
  };
}

// With the kernels of ARETE_KERNEL.
Work refine_grid(const std::string& set, const char* scheme, int levels) {
  if (kernels<float>().name != set) (void)kernels_named(set), std::exit(78);
  RefineOptions options;
  options.levels = levels;
  auto input = std::make_shared<Grid<float>>(Extent{65, 65}, 1.5F);
  for (std::size_t i = 0; i < input->samples().size(); ++i)
    input->samples()[i] = static_cast<float>(i * 7919 % 1000);
  auto refiner = std::make_shared<Refiner<float>>(parse_scheme(scheme), input->extent(), options);
  auto result = std::make_shared<Plane<float>>(refiner->output());
  return [=] { refiner->refine_rows(GridSource<float>(input->view()), 0, result->view()); };
}

using MakeWork = std::function<Work(const std::string& set)>;

const std::map<std::string, MakeWork>& cases() {
  static const std::map<std::string, MakeWork> all{
      {"combine-3", [](const std::string& set) { return combine_row(set, 3); }},
      {"combine-4", [](const std::string& set) { return combine_row(set, 4); }},
      {"combine-9", [](const std::string& set) { return combine_row(set, 9); }},
      {"weave-3-4",
       [](const std::string& set) {
         return weave_row(set, {{0, 3}, {0, 4}});
       }},
      {"weave-3-2",
       [](const std::string& set) {
         return weave_row(set, {{0, 3}, {1, 2}});
       }},
      {"weave-1-8",
       [](const std::string& set) {
         return weave_row(set, {{3, 1}, {0, 8}});
       }},
      {"weave-7-7",
       [](const std::string& set) {
         return weave_row(set, {{0, 7}, {0, 7}});
       }},
      {"weave-1-4-4",
       [](const std::string& set) {
         return weave_row(set, {{1, 1}, {0, 4}, {0, 4}});
       }},
      {"weave-9-ary",
       [](const std::string& set) {
         std::vector<std::pair<Index, int>> phases(9, {0, 6});
         phases[0] = {2, 1};
         return weave_row(set, phases);
       }},
      {"refine-four-parameter",
       [](const std::string& set) { return refine_grid(set, "gentle", 3); }},
      {"refine-cubic",
       [](const std::string& set) { return refine_grid(set, "b-spline:degree=3", 3); }},
      {"refine-one-level",
       [](const std::string& set) { return refine_grid(set, "b-spline:degree=3", 1); }}};
  return all;
}

}  // namespace

extern "C" __attribute__((noinline)) void counted_work(const std::function<void()>& work) {
  work();
}

int main(int argc, char** argv) {
  if (argc < 2) {
    for (const auto& [name, make] : cases()) std::puts(name.c_str());
    return 0;
  }
  const std::string name = argv[1];
  const auto slash = name.find('/');
  const auto found = cases().find(name.substr(0, slash));
  if (slash == std::string::npos || found == cases().end()) return 2;
  const auto work = found->second(name.substr(slash + 1));
  work();  // what is made on first use is not counted
  counted_work(work);
  return 0;
}

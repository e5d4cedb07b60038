// SPDX-License-Identifier: MIT
// The goals of the engine that need no other program, each a ratio of two works done in turn in
// this process; prints a Markdown table.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <string>
#include <thread>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "measure.h"

namespace arete::bench {
namespace {

constexpr int repetitions = 11;
constexpr Extent small_grid{257, 257};
constexpr Extent dem{403, 344};

double count_of(Extent e) { return static_cast<double>(e.rows) * static_cast<double>(e.cols); }

void row(const std::string& work, double measured, const char* unit, const std::string& goal,
         bool holds) {
  std::printf("| %s | %.2f %s | %s | %s |\n", work.c_str(), measured, unit, goal.c_str(),
              holds ? "yes" : "no");
  std::fflush(stdout);
}

std::string at_least(double goal) {
  char text[32];
  std::snprintf(text, sizeof text, ">= %.2f", goal);
  return text;
}

RefineOptions levels(const Scheme& scheme, int binary) {
  RefineOptions options;
  const int arity = scheme.mask().arity();
  options.levels = arity == 2   ? binary
                   : arity == 3 ? std::max(1, 2 * binary / 3)
                   : arity == 4 ? binary / 2
                                : 1;
  return options;
}

// Share of the write limit for `planes` planes, with rows on cache lines or packed.
double share_of_limit(const Scheme& scheme, Extent extent, int planes, bool packed) {
  const Grid<float> input = terrain(extent);
  const Refiner<float> refiner(scheme, extent, levels(scheme, 4));
  const GridSource<float> source(input.view());
  const Extent size = refiner.output();
  const Index stride = packed ? size.cols : (size.cols + 15) / 16 * 16;
  Plane<float> memory({1, planes * size.rows * stride});
  const auto times = interleaved(
      repetitions, cpu_seconds,
      {[&] { fill_past_cache(memory.row(0), memory.cols()); },
       [&] {
         for (Index k = 0; k < planes; ++k)
           refiner.refine_rows(
               source, 0, GridView<float>(memory.row(0) + k * size.rows * stride, size, stride));
       }});
  return times[0] / times[1] * (planes * count_of(size) / static_cast<double>(memory.cols()));
}

void write_limit_rows() {
  const Scheme four = parse_scheme("four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7");
  const Scheme cubic = parse_scheme("b-spline:degree=3");
  for (const auto& [extent, name] : {std::pair{small_grid, "257 x 257"}, {dem, "403 x 344"}}) {
    const std::string at = std::string(", ") + name + " 4 levels, share of the write limit";
    const auto measure = [&](const char* what, const Scheme& scheme, int planes, bool packed,
                             double goal) {
      const double share = share_of_limit(scheme, extent, planes, packed);
      row(what + at, share, "", at_least(goal), share >= goal);
    };
    measure("heights, four-parameter", four, 1, false, 0.70);
    measure("heights, cubic", cubic, 1, false, 0.75);
    measure("heights, cubic, packed rows", cubic, 1, true, 0.50);
    measure("x, y, z planes, four-parameter", four, 3, false, 0.60);
    measure("x, y, z planes, cubic", cubic, 3, false, 0.60);
    measure("x, y, z packed rows, four-parameter", four, 3, true, 0.50);
  }
  for (const char* name :
       {"four-point", "chaikin", "b-spline:degree=2", "b-spline:degree=4", "b-spline:degree=5",
        "dubuc-deslauriers:points=6", "dubuc-deslauriers:points=8", "two-parameter",
        "three-parameter", "difference:a0=1/10,a1=0,a2=3/20,a3=1/4,m=1,raise=1", "three-point",
        "ternary-two-step", "ternary-two-step-9", "ternary-four-point", "four-parameter-c2"}) {
    const double share = share_of_limit(parse_scheme(name), small_grid, 1, false);
    row(std::string("heights, ") + name + ", 257 x 257, share of the write limit", share, "",
        at_least(0.45), share >= 0.45);
  }
}

void tile_rows() {
  for (const char* name :
       {"four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7", "b-spline:degree=3"}) {
    const Scheme scheme = parse_scheme(name);
    const Grid<float> input = terrain(small_grid);
    const Refiner<float> refiner(scheme, small_grid, levels(scheme, 4));
    const GridSource<float> source(input.view());
    const Extent size = refiner.output();
    Plane<float> memory(size);
    float sum = 0;
    const auto times = interleaved(
        repetitions, cpu_seconds,
        {[&] { fill_past_cache(memory.row(0), size.rows * memory.stride()); },
         [&] {
           refiner.for_each_tile(source, {0, size.rows - 1},
                                 [&](Index, Index, GridView<const float> t) { sum += t(0, 0); });
         }});
    const double ratio = times[0] / times[1];
    row("tiles taken in cache, " + scheme.text() + ", times the write limit", ratio, "",
        at_least(1.2), ratio >= 1.2);
    if (sum == 0.125F) std::puts("");
  }
}

void thread_rows() {
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Grid<float> input = terrain(small_grid);
  RefineOptions one = levels(scheme, 4), two = one;
  two.threads = 2;
  const Refiner<float> single(scheme, small_grid, one), both(scheme, small_grid, two);
  const GridSource<float> source(input.view());
  Plane<float> memory(single.output());
  const Index half = memory.rows() * memory.stride() / 2 / 16 * 16;
  const auto times =
      interleaved(2 * repetitions, wall_seconds,
                  {[&] { single.refine_rows(source, 0, memory.view()); },
                   [&] { both.refine_rows(source, 0, memory.view()); },
                   [&] { fill_past_cache(memory.row(0), 2 * half); },
                   [&] {
                     std::thread other([&] { fill_past_cache(memory.row(0), half); });
                     fill_past_cache(memory.row(0) + half, half);
                     other.join();
                   }});
  row("two threads against one (wall)", times[0] / times[1], "x", at_least(1.7),
      times[0] / times[1] >= 1.7);
  std::printf("| the write limit itself, two threads against one | %.2f x | - | - |\n",
              times[2] / times[3]);
}

void one_shot_rows() {
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Grid<float> input = terrain(small_grid);
  const Refiner<float> refiner(scheme, small_grid, levels(scheme, 4));
  const auto touch = [&](Pages pages) {
    Plane<float> plane(refiner.output(), pages);
    // One word a page is enough for the system to bring it.
    for (Index i = 0; i < plane.rows() * plane.stride(); i += 1024) plane.row(0)[i] = 1;
    // Then every sample once, as any writer must.
    fill_past_cache(plane.row(0), plane.rows() * plane.stride());
  };
  const auto times = interleaved(
      repetitions, cpu_seconds,
      {[&] { touch(Pages::ordinary); }, [&] { (void)refiner.plane(input.view(), Pages::ordinary); },
       [&] { touch(Pages::huge); }, [&] { (void)refiner.plane(input.view(), Pages::huge); }});
  row("one shot, 4 KiB pages, against filling the same allocation once", times[1] / times[0], "x",
      "<= 1.15", times[1] / times[0] <= 1.15);
  row("one shot, huge pages, against filling the same allocation once", times[3] / times[2], "x",
      "<= 1.15", times[3] / times[2] <= 1.15);
  row("one shot, huge pages against 4 KiB pages", times[1] / times[3], "x faster", at_least(2),
      times[1] / times[3] >= 2);
}

double nanoseconds_a_sample(Index size, int count) {
  const Scheme scheme = parse_scheme("b-spline:degree=3");
  const Grid<float> input = terrain({size, size});
  RefineOptions options;
  options.levels = count;
  const Refiner<float> refiner(scheme, input.extent(), options);
  const GridSource<float> source(input.view());
  const Extent out = refiner.output();
  float sum = 0;
  // A million samples or more are timed together: asking for processor time is a call of the system.
  const int calls = std::max(1, static_cast<int>(1e6 / count_of(out)));
  const auto stream = [&] {
    for (int call = 0; call < calls; ++call)
      refiner.for_each_tile(source, {0, out.rows - 1},
                            [&](Index, Index, GridView<const float> t) { sum += t(0, 0); });
  };
  const int repeats = count_of(out) > 1e8 ? 1 : 21;
  const double time = interleaved(repeats, cpu_seconds, {stream})[0] / calls;
  if (sum == 0.125F) std::puts("");
  return 1e9 * time / count_of(out);
}

void growth_rows() {
  const double million = nanoseconds_a_sample(65, 4);
  const double little = nanoseconds_a_sample(65, 1);
  const double much = nanoseconds_a_sample(1025, 5);
  row("16 k samples against 1 M, ns a sample", little / million, "x", "<= 2",
      little <= 2 * million);
  row("1.07 G samples streamed against 1 M, ns a sample", much / million, "x", "<= 1.25",
      much <= 1.25 * million);
}

// Peak memory of a process of its own beyond what it had before, less the result.
void memory_row() {
  int ends[2];
  if (pipe(ends) != 0) return;
  if (fork() == 0) {
    const Scheme scheme = parse_scheme("b-spline:degree=3");
    const Grid<float> input = terrain(small_grid);
    const Refiner<float> refiner(scheme, small_grid, levels(scheme, 5));
    rusage before{}, after{};
    getrusage(RUSAGE_SELF, &before);
    const Plane<float> result = refiner.plane(input.view());
    getrusage(RUSAGE_SELF, &after);
    const double result_bytes = 4.0 * static_cast<double>(result.rows() * result.stride());
    const double more =
        (static_cast<double>(after.ru_maxrss - before.ru_maxrss) * 1024 - result_bytes) / 1048576;
    const bool sent = write(ends[1], &more, sizeof more) == sizeof more;
    _exit(sent ? 0 : 1);
  }
  double more = 0;
  const bool got = read(ends[0], &more, sizeof more) == sizeof more;
  wait(nullptr);
  if (got) row("peak memory beyond a result of 67 M samples", more, "MiB", "<= 16", more <= 16);
}

}  // namespace
}  // namespace arete::bench

int main() {
  using namespace arete::bench;
  std::printf("Kernels: %s.\n\n", std::string(arete::kernels<float>().name).c_str());
  std::printf("| work | measured | goal | holds |\n|---|---|---|---|\n");
  memory_row();
  write_limit_rows();
  tile_rows();
  thread_rows();
  one_shot_rows();
  growth_rows();
  return 0;
}

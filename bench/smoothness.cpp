// SPDX-License-Identifier: MIT
// How long proofs take: analyze for every family, and maps of 200 x 200 points. Prints Markdown.
// Usage: bench_smoothness [threads = 2 [points along a side = 200]]. Next to the time on the clock
// stands the processor time of all threads, which a busy machine does not lengthen.
#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include "arete/analysis/limit_norm.h"
#include "arete/analysis/limit_stencil.h"
#include "arete/analysis/smoothness_map.h"
#include "arete/analysis/theorem.h"
#include "arete/scheme/catalogue.h"

namespace {

using arete::Rational;

struct Times {
  double clock = 0;
  double processor = 0;
};

template <class Work>
Times times(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  const std::clock_t processor = std::clock();
  work();
  return {std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count(),
          static_cast<double>(std::clock() - processor) / CLOCKS_PER_SEC};
}

// What `arete analyze` computes.
void analyze(const arete::Scheme& scheme) {
  const arete::Smoothness truth = arete::analyze_smoothness(scheme.mask());
  (void)arete::theorems_for(scheme);
  if (truth.refuted_at) (void)arete::property_1_refuted_by(scheme);
  (void)arete::limit_norm(scheme.mask());
  (void)arete::limit_stencil(scheme.mask());
  (void)arete::derivative_stencil(scheme.mask());
}

std::vector<std::string> schemes() {
  std::vector<std::string> texts;
  for (const arete::Family& family : arete::catalogue())
    if (family.name != "mask" && family.name != "difference") texts.push_back(family.name);
  for (const char* more :
       {"ternary-two-step:b=6/5", "ternary-two-step:b=-3/2", "ternary-two-step-9:b=0.0954174",
        "b-spline:degree=32", "dubuc-deslauriers:points=8", "three-parameter:a=1/4,c=-19/20",
        "three-parameter:m=16,raise=16", "corner-cutting:u=2/5,v=1/7",
        "difference:a0=1/10,a1=0,a2=3/20,a3=1/4,m=1,raise=1",
        "four-parameter:lambda=1/5,mu=1/10,nu=1/3,omega=1/7"})
    texts.emplace_back(more);
  return texts;
}

Times map_times(const char* family, const char* x, const Rational& x0, const Rational& x1,
                const char* y, const Rational& y0, const Rational& y1, int count,
                bool mu_with_lambda) {
  std::vector<Rational> xs, ys;
  for (int i = 0; i < count; ++i) {
    xs.push_back(x0 + (x1 - x0) * i / (count - 1));
    ys.push_back(y0 + (y1 - y0) * i / (count - 1));
  }
  return times([&] {
    (void)arete::smoothness_map(xs, ys, [&](const Rational& u, const Rational& v) {
      arete::ParameterValues values{{x, {u}}, {y, {v}}};
      if (mu_with_lambda) values.push_back({"mu", {u}});
      return std::optional(arete::make_scheme(family, values).mask());
    });
  });
}

}  // namespace

int main(int argc, char** argv) {
  const int threads = argc > 1 ? std::atoi(argv[1]) : 2;
  const int count = argc > 2 ? std::atoi(argv[2]) : 200;
  const tbb::global_control limit(tbb::global_control::max_allowed_parallelism,
                                  static_cast<std::size_t>(std::max(1, threads)));
  std::printf("| scheme | analyze, s | processor, s |\n|---|---|---|\n");
  double slowest = 0;
  for (const std::string& text : schemes()) {
    const arete::Scheme scheme = arete::parse_scheme(text);
    const Times time = times([&] { analyze(scheme); });
    slowest = std::max(slowest, time.processor);
    std::printf("| `%s` | %.3f | %.3f |\n", text.c_str(), time.clock, time.processor);
  }
  std::printf("| slowest | | %.3f |\n\n", slowest);
  std::printf("| map, %d x %d points, L <= 4, %d threads | s | processor, s |\n|---|---|---|\n",
              count, count, threads);
  const auto row = [](const char* name, const Times& time) {
    std::printf("| %s | %.1f | %.1f |\n", name, time.clock, time.processor);
  };
  row("four-parameter, lambda = mu = -1/4..3/4, omega = -1/2..1/2",
      map_times("four-parameter", "lambda", Rational(-1) / 4, Rational(3) / 4, "omega",
                Rational(-1) / 2, Rational(1) / 2, count, true));
  row("three-parameter, a, c = -1..1",
      map_times("three-parameter", "a", -1, 1, "c", -1, 1, count, false));
  row("corner-cutting, u, v = 0..1",
      map_times("corner-cutting", "u", 0, 1, "v", 0, 1, count, false));
}

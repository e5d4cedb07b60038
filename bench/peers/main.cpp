// SPDX-License-Identifier: MIT
// The same job through arete and through the peers that are installed, in turn in this process, one
// thread, processor time; prints a Markdown table.
//
//     bench_peers [SIZE [LEVELS]]        257 4
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "arete/refine/refiner.h"
#include "arete/scheme/catalogue.h"
#include "measure.h"
#include "peer.h"

namespace arete::bench {
namespace {

// The refinement of a plane of the job; 3 planes for points.
class Ours {
 public:
  explicit Ours(const Job& job)
      : refiner_(parse_scheme("b-spline:degree=3"), job.heights.extent(), options(job.levels)),
        planes_{plane(job, 0), plane(job, 1), job.heights} {
    for (Plane<float>& result : results_) result = Plane<float>(refiner_.output());
  }

  void heights() { refine(2); }
  void points() {
    for (std::size_t k = 0; k < 3; ++k) refine(k);
  }
  void heights_one_shot() { (void)refiner_.plane(planes_[2].view()); }
  void points_one_shot() {
    for (const Grid<float>& plane : planes_) (void)refiner_.plane(plane.view());
  }
  void fill() {
    Plane<float>& z = results_[2];
    fill_past_cache(z.row(0), z.rows() * z.stride());
  }
  [[nodiscard]] float height(Index r, Index c) const { return results_[2].row(r)[c]; }

 private:
  static RefineOptions options(int levels) {
    RefineOptions options;
    options.levels = levels;
    return options;
  }
  static Grid<float> plane(const Job& job, int axis) {
    Grid<float> values(job.heights.extent());
    for (Index r = 0; r < values.rows(); ++r)
      for (Index c = 0; c < values.cols(); ++c)
        values(r, c) = static_cast<float>(axis == 0 ? c : r);
    return values;
  }
  void refine(std::size_t k) {
    refiner_.refine_rows(GridSource<float>(planes_[k].view()), 0, results_[k].view());
  }

  Refiner<float> refiner_;
  Grid<float> planes_[3];
  Plane<float> results_[3];
};

// Largest difference from our heights, one input cell or more inside the border.
double largest_difference(const Job& job, const Ours& ours, const std::vector<Vertex>& vertices) {
  const double scale = std::exp2(job.levels);
  const Index border = Index{1} << job.levels;
  const Extent fine = job.fine();
  double largest = 0;
  Index compared = 0;
  for (const Vertex& v : vertices) {
    const auto c = static_cast<Index>(std::lround(v.x * scale));
    const auto r = static_cast<Index>(std::lround(v.y * scale));
    if (r < border || c < border || r >= fine.rows - border || c >= fine.cols - border) continue;
    largest = std::max(largest, static_cast<double>(std::abs(v.z - ours.height(r, c))));
    ++compared;
  }
  const Index inside = (fine.rows - 2 * border) * (fine.cols - 2 * border);
  return compared == inside ? largest : NAN;
}

void compare(const Job& job, const Peer& peer, Ours& ours, double range) {
  const Run run = peer.prepare(job);
  const std::vector<double> times = interleaved(
      peer.repetitions, cpu_seconds,
      {[&] { ours.fill(); }, [&] { peer.points ? ours.points() : ours.heights(); },
       [&] { peer.points ? ours.points_one_shot() : ours.heights_one_shot(); }, run.work});
  const double samples = static_cast<double>(job.fine().rows) *
                         static_cast<double>(job.fine().cols) * (peer.points ? 3 : 1);
  const double limit = times[0] * (peer.points ? 3 : 1);
  std::string agreement = "-";
  if (run.vertices) {
    ours.points();
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", largest_difference(job, ours, run.vertices()) / range);
    agreement = text;
  }
  const double ratio = times[3] / times[1];
  std::printf("| %s | %s | %.4f | %.1f | %.2f %% | %.0f | %.1f | >= %.0f | %s | %s |\n",
              peer.name.c_str(), peer.points ? "x, y, z" : "heights", times[3],
              1e9 * times[3] / samples, 100 * limit / times[3], ratio, times[3] / times[2],
              peer.goal, ratio >= peer.goal ? "yes" : "no", agreement.c_str());
  std::fflush(stdout);
}

}  // namespace
}  // namespace arete::bench

int main(int argc, char** argv) {
  using namespace arete::bench;
  const arete::Index size = argc > 1 ? std::atol(argv[1]) : 257;
  const Job job{terrain({size, size}), argc > 2 ? std::atoi(argv[2]) : 4};
  const auto [low, high] =
      std::minmax_element(job.heights.samples().begin(), job.heights.samples().end());
  const double range = *high - *low;
  Ours ours(job);
  std::printf(
      "| %ld x %ld, %d levels | job | CPU s | ns / number | of write limit | time / arete's, "
      "mapped "
      "memory | / arete's, fresh memory | goal (mapped) | holds | difference inside, of the range "
      "|\n|---|---|---|---|---|---|---|---|---|---|\n",
      static_cast<long>(size), static_cast<long>(size), job.levels);
  std::vector<Peer> peers;
  const auto add = [&](std::vector<Peer> more) {
    for (Peer& peer : more) peers.push_back(std::move(peer));
  };
#ifdef BENCH_HAVE_VTK
  add(vtk_peers());
#endif
#ifdef BENCH_HAVE_GDAL
  add(gdal_peers());
#endif
#ifdef BENCH_HAVE_OPENSUBDIV
  add(opensubdiv_peers());
#endif
#ifdef BENCH_HAVE_CGAL
  add(cgal_peers());
#endif
#ifdef BENCH_HAVE_OPENMESH
  add(openmesh_peers());
#endif
  for (const Peer& peer : peers) compare(job, peer, ours, range);
  return 0;
}

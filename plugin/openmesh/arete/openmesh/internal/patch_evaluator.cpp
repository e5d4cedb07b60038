// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/patch_evaluator.h"

#include <algorithm>
#include <mutex>

#include "arete/parallel/for_each_band.h"

namespace arete::openmesh::detail {
namespace {

// Tall enough that the rows a band recomputes at its start cost little, short enough that the band
// is still in cache when its values are stored.
constexpr Index band_rows = 64;

// Bands of one plane each, kept from one use to the next: fresh memory costs more than the work.
template <class Real>
class BandStock {
 public:
  BandStock(std::size_t planes, Extent size) : planes_(planes), size_(size) {}

  [[nodiscard]] std::vector<Grid<Real>> take() {
    const std::lock_guard lock(mutex_);
    if (stock_.empty()) return std::vector<Grid<Real>>(planes_, Grid<Real>(size_));
    std::vector<Grid<Real>> bands = std::move(stock_.back());
    stock_.pop_back();
    return bands;
  }
  void give_back(std::vector<Grid<Real>> bands) {
    const std::lock_guard lock(mutex_);
    stock_.push_back(std::move(bands));
  }

 private:
  std::size_t planes_;
  Extent size_;
  std::mutex mutex_;
  std::vector<std::vector<Grid<Real>>> stock_;
};

}  // namespace

template <class Real>
void refine_in_bands(std::span<const Refiner<Real>* const> refiners,
                     std::span<const Grid<Real>* const> planes, int threads,
                     const typename PatchEvaluator<Real>::Sink& sink) {
  const Extent fine = refiners.front()->output();
  BandStock<Real> stock(planes.size(), {std::min(band_rows, fine.rows), fine.cols});
  for_each_band(fine.rows, band_rows, threads, [&](Index first, Index count) {
    std::vector<Grid<Real>> bands = stock.take();
    for (std::size_t k = 0; k < planes.size(); ++k)
      refiners[k]->refine_rows(GridSource<Real>(planes[k]->view()), first,
                               GridView<Real>(bands[k].row(0), {count, fine.cols}));
    std::vector<const Real*> rows(planes.size());
    for (Index r = 0; r < count; ++r) {
      for (std::size_t k = 0; k < planes.size(); ++k) rows[k] = bands[k].row(r);
      sink(first + r, rows);
    }
    stock.give_back(std::move(bands));
  });
}

template <class Real>
PatchEvaluator<Real>::PatchEvaluator(const RefinedPatch& patch, int threads)
    : patch_(patch), threads_(threads), refiner_(patch.cols.plan, patch.rows.plan) {}

template <class Real>
void PatchEvaluator<Real>::evaluate(AttributeRule rule, std::span<const Grid<Real>> planes,
                                    const Sink& sink) const {
  if (rule == AttributeRule::scheme)
    by_scheme(planes, sink);
  else
    bilinearly(planes, sink);
}

template <class Real>
void PatchEvaluator<Real>::by_scheme(std::span<const Grid<Real>> planes, const Sink& sink) const {
  const std::vector<const Refiner<Real>*> refiners(planes.size(), &refiner_);
  std::vector<const Grid<Real>*> pointers;
  for (const Grid<Real>& plane : planes) pointers.push_back(&plane);
  refine_in_bands<Real>(refiners, pointers, threads_, sink);
}

template <class Real>
void PatchEvaluator<Real>::bilinearly(std::span<const Grid<Real>> planes, const Sink& sink) const {
  const Extent coarse = patch_.coarse.extent;
  const std::vector<Location>& cols = patch_.cols.samples;
  std::vector<std::vector<Real>> results(planes.size(), std::vector<Real>(cols.size()));
  std::vector<const Real*> rows;
  for (const std::vector<Real>& result : results) rows.push_back(result.data());
  std::vector<Real> between(static_cast<std::size_t>(coarse.cols));
  // a + t (b - a) leaves equal values as they are, and t = 0 does not read beyond them.
  const auto blend = [](Real a, Real b, double t) {
    if (t == 0) return a;
    return t == 1 ? b : a + static_cast<Real>(t) * (b - a);
  };
  for (Index r = 0; r < patch_.rows.fine(); ++r) {
    const Location y = patch_.rows.samples[static_cast<std::size_t>(r)];
    for (std::size_t k = 0; k < planes.size(); ++k) {
      const Real* const upper = planes[k].row(y.cell);
      const Real* const lower = planes[k].row((y.cell + 1) % coarse.rows);
      for (Index c = 0; c < coarse.cols; ++c)
        between[static_cast<std::size_t>(c)] = blend(upper[c], lower[c], y.t);
      for (std::size_t i = 0; i < cols.size(); ++i) {
        const auto left = static_cast<std::size_t>(cols[i].cell);
        results[k][i] = blend(between[left], between[(left + 1) % between.size()], cols[i].t);
      }
    }
    sink(r, rows);
  }
}

template class PatchEvaluator<float>;
template class PatchEvaluator<double>;
template void refine_in_bands(std::span<const Refiner<float>* const>,
                              std::span<const Grid<float>* const>, int,
                              const PatchEvaluator<float>::Sink&);
template void refine_in_bands(std::span<const Refiner<double>* const>,
                              std::span<const Grid<double>* const>, int,
                              const PatchEvaluator<double>::Sink&);

}  // namespace arete::openmesh::detail

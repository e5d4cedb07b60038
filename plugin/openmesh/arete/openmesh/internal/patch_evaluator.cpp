// SPDX-License-Identifier: MIT
#include "arete/openmesh/internal/patch_evaluator.h"

#include <algorithm>

namespace arete::openmesh::detail {
namespace {

// Tall enough that the rows a band recomputes at its start cost little, short enough that the band
// is still in cache when its values are stored.
constexpr Index band_rows = 128;

}  // namespace

template <class Real>
void refine_in_bands(std::span<const Refiner<Real>* const> refiners,
                     std::span<const Grid<Real>* const> planes,
                     const typename PatchEvaluator<Real>::Sink& sink) {
  const Extent fine = refiners.front()->output();
  std::vector<Grid<Real>> bands(planes.size());
  std::vector<const Real*> rows(planes.size());
  for (Index first = 0; first < fine.rows; first += band_rows) {
    const Index count = std::min(band_rows, fine.rows - first);
    for (std::size_t k = 0; k < planes.size(); ++k) {
      if (bands[k].rows() != count) bands[k] = Grid<Real>({count, fine.cols});
      refiners[k]->refine_rows(GridSource<Real>(planes[k]->view()), first, bands[k].view());
    }
    for (Index r = 0; r < count; ++r) {
      for (std::size_t k = 0; k < planes.size(); ++k) rows[k] = bands[k].row(r);
      sink(first + r, rows);
    }
  }
}

template <class Real>
PatchEvaluator<Real>::PatchEvaluator(const RefinedPatch& patch, int threads)
    : patch_(patch), refiner_(patch.cols.plan, patch.rows.plan, threads) {}

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
  refine_in_bands<Real>(refiners, pointers, sink);
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
                              std::span<const Grid<float>* const>,
                              const PatchEvaluator<float>::Sink&);
template void refine_in_bands(std::span<const Refiner<double>* const>,
                              std::span<const Grid<double>* const>,
                              const PatchEvaluator<double>::Sink&);

}  // namespace arete::openmesh::detail

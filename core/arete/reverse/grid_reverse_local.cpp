// SPDX-License-Identifier: MIT
#include "arete/reverse/grid_reverse_local.h"

#include <memory>

#include "arete/parallel/for_each_band.h"
#include "arete/reverse/row_filter.h"

namespace arete {
namespace {

// One step's filters: down over rows, along within one.
template <class T>
struct Filters {
  const LocalReverse<T>& down;
  Index fine_rows;
  Index coarse_rows;
  Index detail_rows;
  Index fine_cols;
  Index coarse_cols;
  Index detail_cols;
  RowFilter<T> analysis;
  RowFilter<T> detail;
  RowFilter<T> synthesis;

  Filters(const GridStepAxes<T>& axes)
      : down(*axes.y.local()),
        fine_rows(axes.y.fine_count()),
        coarse_rows(axes.y.coarse_count()),
        detail_rows(axes.y.detail_count()),
        fine_cols(axes.x.fine_count()),
        coarse_cols(axes.x.coarse_count()),
        detail_cols(axes.x.detail_count()),
        analysis(axes.x.local()->analysis, fine_cols, {1, axes.x.level().arity, 1}),
        detail(axes.x.local()->detail, fine_cols,
               {std::max(1, axes.x.level().arity - 1), axes.x.level().arity, 1}),
        synthesis(axes.x.local()->synthesis, coarse_cols,
                  {axes.x.level().arity, 1, std::max(1, axes.x.level().arity - 1)}) {}
};

template <class T>
std::vector<Filters<T>> filters_of(const std::vector<GridStepAxes<T>>& steps) {
  std::vector<Filters<T>> filters;
  for (const auto& step : steps) filters.emplace_back(step);
  return filters;
}

// out = row i of the matrix over rows of samples, given by `x` and `y`.
template <class T, class X, class Y>
void combine_rows(const SparseRows<T>& matrix, Index i, Index x_count, X&& x, Y&& y, T* out,
                  Index width) {
  std::vector<const T*> taps;
  std::vector<T> weights;
  for (const auto& [col, weight] : matrix.row(i)) {
    taps.push_back(col < x_count ? x(col) : y(col - x_count));
    weights.push_back(weight);
  }
  weighted_sum(out, taps.data(), weights.data(), static_cast<int>(taps.size()), width);
}

// Rows kept of anything: more than any stencil reads, and what the levels run ahead of each other.
constexpr std::size_t spare_rows = 8;

// One level of the pipe: rows of the level before go in, rows of coarse samples and details beside
// them come out, made when they are asked for.
template <class T>
class AnalysisLevel {
 public:
  AnalysisLevel(const Filters<T>& filters, AnalysisLevel* before, GridView<const T> fine)
      : f_(filters),
        before_(before),
        fine_(fine),
        lows_(f_.down.detail.most_taps() + spare_rows, f_.fine_cols),
        halves_(f_.down.detail.most_taps() + f_.down.analysis.most_taps() + spare_rows,
                f_.coarse_cols + f_.detail_cols),
        high_(static_cast<std::size_t>(f_.fine_cols)) {}

  // Row j of coarse samples, the details cd behind them.
  const T* halves(Index j) {
    return halves_.row(j, [&](T* out) { part(low(j), out, out + f_.coarse_cols); });
  }
  void make_high(Index i, T* dc, T* dd) {
    combine_rows(
        f_.down.detail, i, f_.fine_rows, [&](Index r) { return fine(r); },
        [&](Index j) { return low(j); }, high_.data(), f_.fine_cols);
    part(high_.data(), dc, dd);
  }
  [[nodiscard]] const Filters<T>& filters() const { return f_; }

 private:
  const T* fine(Index r) { return before_ ? before_->halves(r) : fine_.row(r); }
  const T* low(Index j) {
    const Index copied = f_.down.analysis.copied_column(j);
    if (copied >= 0) return fine(copied);
    return lows_.row(j, [&](T* out) {
      combine_rows(
          f_.down.analysis, j, f_.fine_rows, [&](Index r) { return fine(r); },
          [](Index) -> const T* { return nullptr; }, out, f_.fine_cols);
    });
  }
  void part(const T* row, T* low_half, T* high_half) {
    f_.analysis.apply(row, nullptr, low_half, work_);
    f_.detail.apply(row, low_half, high_half, work_);
  }

  const Filters<T>& f_;
  AnalysisLevel* before_;
  GridView<const T> fine_;
  RowCache<T> lows_;
  RowCache<T> halves_;
  std::vector<T> high_;
  typename RowFilter<T>::Workspace work_;
};

// One level of the pipe back: rows of the finer grid, made when they are asked for.
template <class T>
class SynthesisLevel {
 public:
  SynthesisLevel(const Filters<T>& filters, const GridDetails<T>& details, SynthesisLevel* before,
                 const Grid<T>& coarse)
      : f_(filters),
        details_(details),
        before_(before),
        coarse_(coarse),
        fines_(f_.down.synthesis.most_taps() + spare_rows, f_.fine_cols),
        lows_(f_.down.synthesis.most_taps() + spare_rows, f_.fine_cols),
        highs_(f_.down.synthesis.most_taps() + spare_rows, f_.fine_cols) {}

  const T* row(Index r) {
    return fines_.row(r, [&](T* out) { make(r, out); });
  }
  void make(Index r, T* out) {
    combine_rows(
        f_.down.synthesis, r, f_.coarse_rows, [&](Index j) { return low(j); },
        [&](Index i) { return high(i); }, out, f_.fine_cols);
  }

 private:
  const T* low(Index j) {
    return lows_.row(j, [&](T* out) {
      f_.synthesis.apply(before_ ? before_->row(j) : coarse_.row(j), details_.cd.row(j), out,
                         work_);
    });
  }
  const T* high(Index i) {
    return highs_.row(
        i, [&](T* out) { f_.synthesis.apply(details_.dc.row(i), details_.dd.row(i), out, work_); });
  }

  const Filters<T>& f_;
  const GridDetails<T>& details_;
  SynthesisLevel* before_;
  const Grid<T>& coarse_;
  RowCache<T> fines_;
  RowCache<T> lows_;
  RowCache<T> highs_;
  typename RowFilter<T>::Workspace work_;
};

// Rows taken at a time, for threads; what lies beside a run is made twice.
Index rows_a_run(Index rows, int threads) {
  return threads == 1 ? std::max<Index>(rows, 1) : std::clamp<Index>(rows / 64, 16, 512);
}

}  // namespace

template <class T>
void decompose_by_rows(const std::vector<GridStepAxes<T>>& steps, GridView<const T> fine,
                       Grid<T>& coarse, std::vector<GridDetails<T>>& details, int threads) {
  const std::vector<Filters<T>> filters = filters_of(steps);
  // Runs of the first level's coarse rows; the other levels go along in proportion.
  const Index all = filters.front().coarse_rows;
  for_each_band(all, rows_a_run(all, threads), threads, [&](Index first, Index count) {
    std::vector<std::unique_ptr<AnalysisLevel<T>>> levels;
    for (const auto& f : filters)
      levels.push_back(std::make_unique<AnalysisLevel<T>>(
          f, levels.empty() ? nullptr : levels.back().get(), fine));
    for (Index at = first; at < first + count; ++at)
      for (std::size_t k = 0; k < levels.size(); ++k) {
        const Filters<T>& f = filters[k];
        const auto share = [&](Index rows, Index i) { return i * rows / all; };
        for (Index j = share(f.coarse_rows, at); j < share(f.coarse_rows, at + 1); ++j) {
          const T* halves = levels[k]->halves(j);
          if (k + 1 == levels.size()) std::copy_n(halves, f.coarse_cols, coarse.row(j));
          std::copy_n(halves + f.coarse_cols, f.detail_cols, details[k].cd.row(j));
        }
        for (Index i = share(f.detail_rows, at); i < share(f.detail_rows, at + 1); ++i)
          levels[k]->make_high(i, details[k].dc.row(i), details[k].dd.row(i));
      }
  });
}

template <class T>
void reconstruct_by_rows(const std::vector<GridStepAxes<T>>& steps, const Grid<T>& coarse,
                         std::span<const GridDetails<T>> details, Grid<T>& fine, int threads) {
  const std::vector<Filters<T>> filters = filters_of(steps);
  for_each_band(fine.rows(), rows_a_run(fine.rows(), threads), threads, [&](Index first, Index count) {
    std::vector<std::unique_ptr<SynthesisLevel<T>>> levels;  // the coarsest first
    for (std::size_t k = filters.size(); k-- > 0;)
      levels.push_back(std::make_unique<SynthesisLevel<T>>(
          filters[k], details[k], levels.empty() ? nullptr : levels.back().get(), coarse));
    for (Index r = first; r < first + count; ++r) levels.back()->make(r, fine.row(r));
  });
}

template void decompose_by_rows(const std::vector<GridStepAxes<float>>&, GridView<const float>,
                                Grid<float>&, std::vector<GridDetails<float>>&, int);
template void decompose_by_rows(const std::vector<GridStepAxes<double>>&, GridView<const double>,
                                Grid<double>&, std::vector<GridDetails<double>>&, int);
template void reconstruct_by_rows(const std::vector<GridStepAxes<float>>&, const Grid<float>&,
                                  std::span<const GridDetails<float>>, Grid<float>&, int);
template void reconstruct_by_rows(const std::vector<GridStepAxes<double>>&, const Grid<double>&,
                                  std::span<const GridDetails<double>>, Grid<double>&, int);

}  // namespace arete

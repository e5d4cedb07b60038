// SPDX-License-Identifier: MIT
#include "arete/fractal/chaos_game.h"

#include <algorithm>

namespace arete {

ChaosGame::ChaosGame(const MatrixSet<double>& set, const std::vector<Matrix<double>>& arcs,
                     std::uint64_t seed)
    : random_(seed) {
  if (arcs.empty()) throw InvalidField("the chaos game needs at least one arc");
  for (const Matrix<double>& arc : arcs) arcs_.emplace_back(set, arc);
  row_.assign(static_cast<std::size_t>(set.size()), 0);
  row_.front() = 1;
  moved_ = row_;
  point_.assign(static_cast<std::size_t>(arcs.front().cols()), 0);
  for (int i = 0; i < warm_up; ++i) step();
}

// The high half of a 64-bit product of 32 random bits: equal chances to within count / 2^32.
std::size_t ChaosGame::draw(std::size_t count) {
  return static_cast<std::size_t>(((random_() >> 32U) * count) >> 32U);
}

void ChaosGame::step() {
  const MatrixSet<double>& set = arcs_.front().set();
  const Matrix<double>& map = set.maps[draw(set.maps.size())];
  std::fill(moved_.begin(), moved_.end(), 0);
  for (int i = 0; i < map.rows(); ++i)
    for (int j = 0; j < map.cols(); ++j)
      moved_[static_cast<std::size_t>(j)] += row_[static_cast<std::size_t>(i)] * map(i, j);
  row_.swap(moved_);
}

const std::vector<double>& ChaosGame::next() {
  step();
  const Matrix<double>& control = arcs_[draw(arcs_.size())].control();
  for (int c = 0; c < control.cols(); ++c) {
    double sum = 0;
    for (int i = 0; i < control.rows(); ++i)
      sum += row_[static_cast<std::size_t>(i)] * control(i, c);
    point_[static_cast<std::size_t>(c)] = sum;
  }
  return point_;
}

}  // namespace arete

// SPDX-License-Identifier: MIT
#include "arete/topology/height_triangles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <string>

#include "arete/topology/lattice_triangles.h"
#include "arete/topology/triangle_samples.h"

namespace arete {
namespace {

using Corner = LatticeTriangles::Corner;

constexpr double mismatch = std::numeric_limits<double>::infinity();

// The sample of a triangle that shall become a vertex.
struct Candidate {
  double error = 0;
  int triangle = 0;
  unsigned version = 0;  // of the triangle when it was looked at
  Corner sample;

  // The greater one comes first; of equals that of the lower triangle, so that the result is one.
  [[nodiscard]] friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.error != b.error ? a.error < b.error : a.triangle > b.triangle;
  }
};

template <class T>
class Triangulation {
 public:
  Triangulation(GridView<const T> heights, Index most, const std::function<void(double)>& progress)
      : heights_(heights), most_(most), progress_(progress), mesh_(heights.extent()) {
    look_at(0);
    look_at(1);
  }

  HeightTriangles run() {
    cut_out_missing();
    refine();
    return result();
  }

 private:
  [[nodiscard]] T height(const Corner& at) const { return heights_(at.y, at.x); }
  [[nodiscard]] bool valid(const Corner& at) const { return std::isfinite(height(at)); }
  [[nodiscard]] bool kept(int triangle) const {
    const auto corners = mesh_.corners(triangle);
    return std::all_of(corners.begin(), corners.end(), [&](const Corner& c) { return valid(c); });
  }

  // The vertical distance of a sample from the triangle over or under it.
  [[nodiscard]] double error(const std::array<Corner, 3>& corners, const Corner& at,
                             const std::array<double, 3>& share) const {
    double there = 0;
    for (std::size_t k = 0; k < 3; ++k) there += share[k] * static_cast<double>(height(corners[k]));
    return std::abs(there - static_cast<double>(height(at)));
  }
  // Whether a sample lies on an edge between valid corners: the triangle beyond may hold it.
  [[nodiscard]] bool on_valid_edge(const std::array<Corner, 3>& corners, const Corner& at) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Corner& p = corners[(k + 1) % 3];
      const Corner& q = corners[(k + 2) % 3];
      if (valid(p) && valid(q) && LatticeTriangles::area(p, q, at) == 0) return true;
    }
    return false;
  }

  // Finds the candidate of a triangle: in one that is kept a missing sample, otherwise that of the
  // largest error; in one that is not, a valid sample. Of samples that do not belong the one
  // nearest to the middle, which makes the roundest triangles.
  void look_at(int triangle) {
    const auto index = static_cast<std::size_t>(triangle);
    if (index >= versions_.size()) versions_.resize(index + 1, 0);
    Candidate best{0, triangle, ++versions_[index], {}};
    const auto corners = mesh_.corners(triangle);
    const bool keep = kept(triangle);
    double nearest = mismatch;
    const auto offer_mismatch = [&](const Corner& at) {
      double distance = 0;
      for (const Corner& c : corners)
        distance += std::hypot(static_cast<double>(at.x - c.x), static_cast<double>(at.y - c.y));
      if (distance >= nearest) return;
      nearest = distance;
      best.error = mismatch;
      best.sample = at;
    };
    for_each_sample(corners, [&](const Corner& at, const std::array<double, 3>& share) {
      if (at == corners[0] || at == corners[1] || at == corners[2]) return;
      if (valid(at) != keep) {
        if (keep || !on_valid_edge(corners, at)) offer_mismatch(at);
        return;
      }
      if (!keep || best.error == mismatch) return;
      const double distance = error(corners, at, share);
      if (distance <= best.error) return;
      best.error = distance;
      best.sample = at;
    });
    if (best.error > 0) queue_.push(best);
  }

  void insert(const Candidate& candidate) {
    changed_ = mesh_.insert(candidate.triangle, candidate.sample);
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    for (const int triangle : changed_) look_at(triangle);
  }

  // The next candidate that is not outdated, or nothing.
  [[nodiscard]] const Candidate* next() {
    while (!queue_.empty()) {
      const Candidate& top = queue_.top();
      if (versions_[static_cast<std::size_t>(top.triangle)] == top.version) return &top;
      queue_.pop();
    }
    return nullptr;
  }

  Candidate take() {
    const Candidate top = queue_.top();
    queue_.pop();
    return top;
  }

  // A triangle that holds a sample, by a walk from the last changed one.
  [[nodiscard]] int locate(const Corner& at) const {
    int triangle = changed_.empty() ? 0 : changed_.back();
    for (int k = 0; k < 3; ++k) {
      const auto corners = mesh_.corners(triangle);
      const auto edge = static_cast<std::size_t>(k);
      if (LatticeTriangles::area(corners[(edge + 1) % 3], corners[(edge + 2) % 3], at) >= 0)
        continue;
      triangle = mesh_[triangle].across[edge];
      k = -1;
    }
    return triangle;
  }

  // Makes the corners of a cell vertices. No circle through them holds another sample, so that they
  // are the corners of two triangles then. \returns whether one of them is new.
  bool insert_cell(Index row, Index col) {
    bool any = false;
    for (const Corner& at :
         {Corner{col, row}, Corner{col + 1, row}, Corner{col, row + 1}, Corner{col + 1, row + 1}}) {
      const int triangle = locate(at);
      const auto corners = mesh_.corners(triangle);
      if (std::find(corners.begin(), corners.end(), at) != corners.end()) continue;
      insert({0, triangle, 0, at});
      any = true;
    }
    return any;
  }

  // Gives triangles to cells with four valid corners of which one is left out. \returns whether
  // that made a new vertex.
  bool take_in() {
    const std::vector<bool> held = held_samples(heights_, mesh_, [&](int t) { return kept(t); });
    const Index cols = heights_.cols();
    bool any = false;
    for (Index r = 0; r + 1 < heights_.rows(); ++r) {
      for (Index c = 0; c + 1 < cols; ++c) {
        const std::array<Corner, 4> cell{Corner{c, r}, Corner{c + 1, r}, Corner{c, r + 1},
                                         Corner{c + 1, r + 1}};
        const auto is_held = [&](const Corner& at) {
          return held[static_cast<std::size_t>(at.y * cols + at.x)];
        };
        if (!std::all_of(cell.begin(), cell.end(), [&](const Corner& at) { return valid(at); }) ||
            std::all_of(cell.begin(), cell.end(), is_held))
          continue;
        any = insert_cell(r, c) || any;
      }
    }
    return any;
  }

  // Goes on until every triangle holds samples of one kind. Later the outline stands fast.
  void cut_out_missing() {
    do {
      while (next() != nullptr && queue_.top().error == mismatch) insert(take());
    } while (take_in());
    for (int t = 0; t < mesh_.count(); ++t) {
      if (kept(t))
        ++kept_;
      else
        mesh_.freeze(t);
    }
    if (kept_ == 0)
      throw InvalidField("no three neighbouring samples are all valid: there is no triangle");
    if (kept_ > most_)
      throw InvalidField("the outline of the missing samples alone takes " + std::to_string(kept_) +
                         " triangles, more than " + std::to_string(most_) +
                         "; allow that many, or fill the holes first (gdal_fillnodata.py)");
  }

  // Triangles that a new vertex adds to those kept.
  [[nodiscard]] Index added(const Candidate& candidate) const {
    const int edge = mesh_.edge_under(candidate.triangle, candidate.sample);
    if (edge < 0) return 2;
    const int beyond = mesh_[candidate.triangle].across[static_cast<std::size_t>(edge)];
    return beyond < 0 || mesh_[beyond].frozen ? 1 : 2;
  }

  void refine() {
    double highest = 0;
    for (Index r = 0; r < heights_.rows(); ++r)
      for (Index c = 0; c < heights_.cols(); ++c)
        if (std::isfinite(heights_(r, c)))
          highest = std::max(highest, std::abs(static_cast<double>(heights_(r, c))));
    const double rounding = 4 * static_cast<double>(std::numeric_limits<T>::epsilon()) * highest;
    while (const Candidate* top = next()) {
      if (top->error <= rounding) return;
      const Index more = added(*top);
      if (kept_ + more > most_) return;
      kept_ += more;
      if (progress_ && kept_ % 1024 < more)
        progress_(static_cast<double>(kept_) / static_cast<double>(most_));
      insert(take());
    }
  }

  HeightTriangles result() const {
    HeightTriangles out;
    const Extent extent = heights_.extent();
    const auto sample = [&](const Corner& at) { return at.y * extent.cols + at.x; };
    std::vector<int> number(mesh_.vertices().size(), -1);
    for (int t = 0; t < mesh_.count(); ++t)
      if (kept(t))
        for (const int v : mesh_[t].corners) number[static_cast<std::size_t>(v)] = 0;
    std::vector<int> order;
    for (std::size_t v = 0; v < number.size(); ++v)
      if (number[v] == 0) order.push_back(static_cast<int>(v));
    const auto sample_of = [&](int v) {
      return sample(mesh_.vertices()[static_cast<std::size_t>(v)]);
    };
    std::sort(order.begin(), order.end(),
              [&](int a, int b) { return sample_of(a) < sample_of(b); });
    for (std::size_t k = 0; k < order.size(); ++k) {
      number[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
      out.samples.push_back(sample_of(order[k]));
    }
    for (int t = 0; t < mesh_.count(); ++t) {
      if (!kept(t)) continue;
      auto corners = mesh_[t].corners;
      for (int& v : corners) v = number[static_cast<std::size_t>(v)];
      out.triangles.push_back(corners);
    }
    measure(out);
    return out;
  }

  // Afresh, with a look at every sample of every triangle that is kept.
  void measure(HeightTriangles& out) const {
    for (int t = 0; t < mesh_.count(); ++t) {
      if (!kept(t)) continue;
      const auto corners = mesh_.corners(t);
      for_each_sample(corners, [&](const Corner& at, const std::array<double, 3>& share) {
        out.largest_error = std::max(out.largest_error, error(corners, at, share));
      });
    }
    const std::vector<bool> held = held_samples(heights_, mesh_, [&](int t) { return kept(t); });
    for (Index r = 0; r < heights_.rows(); ++r)
      for (Index c = 0; c < heights_.cols(); ++c)
        if (valid({c, r}) && !held[static_cast<std::size_t>(r * heights_.cols() + c)])
          ++out.left_out;
  }

  GridView<const T> heights_;
  Index most_;
  const std::function<void(double)>& progress_;
  LatticeTriangles mesh_;
  std::vector<unsigned> versions_;
  std::priority_queue<Candidate> queue_;
  std::vector<int> changed_;
  Index kept_ = 0;
};

template <class T>
HeightTriangles triangulate(GridView<const T> heights, Index most,
                            const std::function<void(double)>& progress) {
  const std::string size =
      std::to_string(heights.rows()) + " x " + std::to_string(heights.cols()) + " samples";
  if (heights.rows() < 2 || heights.cols() < 2)
    throw InvalidField(size + " make no triangle; at least 2 x 2 are needed");
  if (heights.rows() > std::numeric_limits<int>::max() / heights.cols())
    throw InvalidField(size + " are more than 2^31 - 1; use fewer levels");
  if (most < 2) throw InvalidField("a surface takes at least 2 triangles");
  return Triangulation<T>(heights, most, progress).run();
}

}  // namespace

HeightTriangles triangulate_heights(GridView<const double> heights, Index most,
                                    const std::function<void(double)>& progress) {
  return triangulate(heights, most, progress);
}

HeightTriangles triangulate_heights(GridView<const float> heights, Index most,
                                    const std::function<void(double)>& progress) {
  return triangulate(heights, most, progress);
}

}  // namespace arete

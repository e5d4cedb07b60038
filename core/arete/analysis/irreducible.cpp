// SPDX-License-Identifier: MIT
#include <cstdint>

#include "arete/algebra/prime_field.h"
#include "arete/analysis/joint_spectral_radius.h"

namespace arete {
namespace {

using prime_field::inverse;
using prime_field::prime;
using Vector = std::vector<std::uint64_t>;

// Row echelon form of the span met so far.
class Span {
 public:
  // Whether v was outside; it is inside afterwards.
  bool add(Vector v) {
    for (const auto& [pivot, row] : rows_)
      if (const std::uint64_t factor = v[pivot]; factor != 0)
        for (std::size_t i = 0; i < v.size(); ++i)
          v[i] = (v[i] + (prime - factor) * row[i]) % prime;
    for (std::size_t pivot = 0; pivot < v.size(); ++pivot) {
      if (v[pivot] == 0) continue;
      const std::uint64_t scale = inverse(v[pivot]);
      for (std::uint64_t& x : v) x = x * scale % prime;
      rows_.emplace_back(pivot, std::move(v));
      return true;
    }
    return false;
  }
  [[nodiscard]] std::size_t dimension() const { return rows_.size(); }

 private:
  std::vector<std::pair<std::size_t, Vector>> rows_;
};

}  // namespace

bool is_irreducible(const LocalMatrices& local) {
  const auto n = static_cast<std::size_t>(local.size);
  if (n > 16) return false;
  std::vector<Vector> generators;
  for (const auto& matrix : local.matrices) {
    Vector entries;
    for (int i = 0; i < local.size; ++i)
      for (int j = 0; j < local.size; ++j) {
        const auto entry = prime_field::residue(matrix(i, j));
        if (!entry) return false;  // the prime does not fit; not shown
        entries.push_back(*entry);
      }
    generators.push_back(std::move(entries));
  }
  Vector identity(n * n, 0);
  for (std::size_t i = 0; i < n; ++i) identity[i * n + i] = 1;
  Span span;
  span.add(identity);
  std::vector<Vector> found = {identity};
  for (std::size_t next = 0; next < found.size(); ++next)
    for (const Vector& g : generators) {
      Vector product(n * n, 0);
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < n; ++k)
          for (std::size_t j = 0; j < n; ++j)
            product[i * n + j] =
                (product[i * n + j] + g[i * n + k] * found[next][k * n + j]) % prime;
      if (span.add(product)) found.push_back(std::move(product));
    }
  return span.dimension() == n * n;
}

}  // namespace arete

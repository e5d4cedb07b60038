// SPDX-License-Identifier: MIT
#pragma once

#include <list>
#include <memory>
#include <mutex>

#include "arete/field/row_source.h"
#include "arete/variational/cardinal.h"

namespace arete {

/// The control rows of a raster too large for memory: give it to a Refiner in place of the raster's
/// own source, and the limit passes through the samples.
///
/// Rows are solved in blocks of block_rows at fixed places, each with `halo()` rows more on either
/// side, where the column systems are cut off (reflected); at the raster's own ends the boundary
/// holds. What lies further away would change a result by less than 2^-53 of the largest sample, so
/// that the difference to cardinal_control is rounding. Blocks do not depend on who asks for which
/// row, so results are bit-identical whatever the bands and threads. Where the halo is more than
/// the raster, there is one block.
///
/// Memory: keep_blocks blocks and one more being made, of (block_rows + 2 halo) x cols doubles each
/// at most. Thread-safe: one thread makes a block, the others wait for it.
template <class T>
class CardinalSource final : public RowSource<T> {
 public:
  static constexpr Index block_rows = 128;
  static constexpr std::size_t keep_blocks = 4;

  /// The source must outlive this. \throws InvalidField see CardinalAxis.
  CardinalSource(const RowSource<T>& source, const Stencil& limit_x, const Stencil& limit_y,
                 const Boundaries& boundaries);

  [[nodiscard]] Extent extent() const override { return source_.extent(); }
  /// \throws InvalidField if a sample of the block or its halo is not finite.
  void read(Index r, T* out) const override;

  [[nodiscard]] Index halo() const { return halo_; }
  /// Bytes held at most.
  [[nodiscard]] double working_bytes() const;

 private:
  struct Block {
    Index number = 0;
    Grid<T> rows;
  };

  [[nodiscard]] std::shared_ptr<const Block> block(Index number) const;
  [[nodiscard]] std::shared_ptr<const Block> solved(Index number) const;

  const RowSource<T>& source_;
  CardinalAxis<double> x_;
  Stencil limit_y_;
  Boundary boundary_y_;
  Index halo_ = 0;
  Index rows_in_block_ = block_rows;
  mutable std::mutex mutex_;
  mutable std::list<std::shared_ptr<const Block>> kept_;
};

}  // namespace arete

// SPDX-License-Identifier: MIT
// Any bytes as a details file, of a raster and of a mesh: they are read or refused, never a crash.
// The lengths and the checksum are put right first, so that what lies behind them is reached too.
#include <zlib.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>

#include "arete/reverse/byte_stream.h"
#include "arete/reverse/details_file.h"
#include "arete/reverse/mesh_details_file.h"
#include "arete/scheme/catalogue.h"

namespace {

using namespace arete;

Bytes unpack(std::span<const std::uint8_t> bytes, std::size_t size) {
  Bytes unpacked(size);
  uLongf found = size;
  if (uncompress(unpacked.data(), &found, bytes.data(), bytes.size()) != Z_OK || found != size)
    return {};
  return unpacked;
}

// Steps that are as long as the file claims may take minutes to prepare: sizes are what is read.
void read_raster(const Bytes& bytes) {
  try {
    const DetailsFile file = decode_details(bytes, unpack);
    const GridPyramid pyramid(parse_scheme(file.scheme).mask(), file.fine, file.options());
    for (const BandDetails& band : file.bands) (void)coarsened(band.valid, pyramid, file.levels);
  } catch (const InvalidDetails&) {
  }
}

// Level i of the file, over a mesh and its step if that is one of grids.
void restore(const MeshDetailsFile& file, std::size_t i, const MeshFaces& coarse,
             const std::optional<GridStep>& grid) {
  const MeshLevelDetails& level = file.levels[i];
  const MeshDecomposition<double> step{
      file.rule,
      {coarse, level.place, level.faces, grid ? std::make_shared<const GridStep>(*grid) : nullptr},
      {},
      level.details,
      file.lossy ? Grid<double>(level.details.extent()) : level.remainder,
      true};
  try {
    (void)reconstruct_mesh<double>(step, Grid<double>({coarse.vertices, 3}).view());
    (void)refined_faces(step.mesh, file.rule.scheme);
  } catch (const InvalidField&) {
  }
}

void read_mesh(const Bytes& bytes) {
  try {
    const MeshDetailsFile file = decode_mesh_details(bytes, unpack);
    // On a mesh it does not belong to, and for grids on the one it claims.
    const MeshFaces tetrahedron{4, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
    std::optional<GridStep> grid = file.grid;
    for (std::size_t i = 0; i < file.levels.size(); ++i) {
      if (grid && i > 0) grid = grid->coarser();
      restore(file, i, tetrahedron, grid);
      if (grid) restore(file, i, grid->coarse_faces(), grid);
    }
  } catch (const InvalidDetails&) {
  } catch (const InvalidField&) {  // a grid with no coarser one
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes bytes(data, data + size);
  read_raster(bytes);
  read_mesh(bytes);
  if (size < 28) return 0;
  bytes.resize(size - 4);
  Bytes length;
  put_integer(length, size, 8);
  std::copy(length.begin(), length.end(), bytes.begin() + 16);
  put_integer(bytes, checksum(bytes), 4);
  read_raster(bytes);
  read_mesh(bytes);
  return 0;
}

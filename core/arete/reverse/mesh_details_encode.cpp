// SPDX-License-Identifier: MIT
#include "arete/reverse/byte_stream.h"
#include "arete/reverse/mesh_details_file.h"

namespace arete {
namespace {

// Each number's step from the one before, plus one, folded to 0, -1, 1, -2, ...: runs of numbered
// things become runs of one byte. In planes of four bytes.
Bytes steps_of(const std::vector<Index>& numbers) {
  Bytes planes(4 * numbers.size());
  Index before = -1;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Index step = numbers[i] - before - 1;
    before = numbers[i];
    const auto folded = static_cast<std::uint64_t>(step >= 0 ? 2 * step : -2 * step - 1);
    for (std::size_t k = 0; k < 4; ++k)
      planes[k * numbers.size() + i] = static_cast<std::uint8_t>(folded >> (8 * k));
  }
  return planes;
}

void write_rule(details::Writer& out, MeshRule rule) {
  out.line("scheme", to_string(rule.scheme));
  out.line("rim", to_string(rule.rim));
}

void write_grid(details::Writer& out, const GridStep& grid) {
  out.line("scheme", "grid");
  out.line("grid_scheme", grid.scheme.text());
  out.line("boundary_x", to_string(grid.boundaries.x));
  out.line("boundary_y", to_string(grid.boundaries.y));
  out.line("rows", grid.fine.rows);
  out.line("cols", grid.fine.cols);
  out.line("mirrored", grid.mirrored ? 1 : 0);
}

}  // namespace

Bytes encode_mesh_details(const MeshDetailsFile& file, const Pack& pack) {
  details::Writer out(details::mesh_kind, pack);
  if (file.grid)
    write_grid(out, *file.grid);
  else
    write_rule(out, file.rule);
  out.line("mode", to_string(file.mode));
  out.line("lossy", file.lossy ? 1 : 0);
  out.line("coarse_faces", file.coarse_faces);
  out.line("coarse_positions", file.coarse_positions);
  out.line("attributes", static_cast<Index>(file.attributes.size()));
  for (const std::string& name : file.attributes) out.line("attribute", name);
  out.line("levels", static_cast<Index>(file.levels.size()));
  for (const MeshLevelDetails& level : file.levels) {
    std::string sizes = std::to_string(level.vertices()) + " " + std::to_string(level.faces.size());
    for (const Bytes& bytes : level.attributes) sizes += " " + std::to_string(bytes.size());
    out.line("level", sizes);
  }
  out.notes("");
  for (std::size_t i = file.levels.size(); i-- > 0;) {
    const MeshLevelDetails& level = file.levels[i];
    std::vector<Index> numbers;
    std::vector<Index> turns;
    for (const auto& place : level.faces) {
      numbers.push_back(place.face);
      turns.push_back(place.turn);
    }
    out.block(steps_of(level.place));
    out.block(steps_of(numbers));
    out.block(steps_of(turns));
    out.block(to_planes(level.details.samples(), file.lossy ? 4 : 8));
    if (!file.lossy) out.block(to_planes(level.remainder.samples(), 8));
    for (const Bytes& bytes : level.attributes) out.block(bytes);
  }
  return out.finished();
}

std::uint32_t checksum(const MeshFaces& mesh) {
  Bytes bytes;
  put_integer(bytes, static_cast<std::uint64_t>(mesh.vertices), 8);
  for (const auto& face : mesh.faces) {
    put_integer(bytes, face.size(), 4);
    for (const Index v : face) put_integer(bytes, static_cast<std::uint64_t>(v), 8);
  }
  return checksum(std::span<const std::uint8_t>(bytes));
}

}  // namespace arete

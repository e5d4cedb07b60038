// SPDX-License-Identifier: MIT
#include "arete/reverse/byte_stream.h"
#include "arete/reverse/mesh_details_file.h"
#include "arete/scheme/catalogue.h"

namespace arete {
namespace {

using details::damaged;
using details::Reader;

constexpr Index largest = (Index{1} << 31) - 1;

// The numbers that steps_of() wrote, each of which must lie in 0..highest.
std::vector<Index> from_steps(const Bytes& planes, Index highest, const char* what) {
  std::vector<Index> numbers(planes.size() / 4);
  Index before = -1;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::uint64_t folded = 0;
    for (std::size_t k = 0; k < 4; ++k)
      folded |= static_cast<std::uint64_t>(planes[k * numbers.size() + i]) << (8 * k);
    const Index half = static_cast<Index>(folded / 2);
    before += 1 + (folded % 2 == 0 ? half : -half - 1);
    if (before < 0 || before > highest) damaged(std::string(what) + " are out of range");
    numbers[i] = before;
  }
  return numbers;
}

void check_each_once(const std::vector<Index>& numbers, const char* what) {
  std::vector<std::uint8_t> seen(numbers.size(), 0);
  for (const Index number : numbers)
    if (std::exchange(seen[static_cast<std::size_t>(number)], 1) != 0)
      damaged(std::string(what) + " " + std::to_string(number) + " stands twice");
}

GridStep grid_step_of(Reader& in) {
  try {
    Scheme scheme = parse_scheme(in.text("grid_scheme"));
    Boundaries boundaries;
    boundaries.x = parse_boundary(in.text("boundary_x"));
    boundaries.y = parse_boundary(in.text("boundary_y"));
    Extent fine;
    fine.rows = in.number("rows", 2, largest);
    fine.cols = in.number("cols", 2, largest);
    return {std::move(scheme), boundaries, fine, in.number("mirrored", 0, 1) == 1};
  } catch (const std::invalid_argument& error) {
    damaged(error.what());
  }
}

MeshRule rule_of(Reader& in, std::string_view name) {
  const auto scheme = parse_mesh_scheme(name);
  const auto rim = parse_mesh_rim(in.text("rim"));
  if (!scheme || !rim) damaged("the scheme in the header");
  return {*scheme, *rim};
}

MeshLevelDetails read_level(Reader& in, const std::vector<Index>& sizes, bool lossy) {
  MeshLevelDetails level;
  const Index vertices = sizes[0];
  const Index faces = sizes[1];
  const auto bytes_of = [](Index count, int width) {
    return static_cast<std::uint64_t>(count) * static_cast<std::uint64_t>(width);
  };
  level.place = from_steps(in.block(bytes_of(vertices, 4)), vertices - 1, "vertices");
  check_each_once(level.place, "vertex");
  const auto numbers = from_steps(in.block(bytes_of(faces, 4)), faces - 1, "faces");
  check_each_once(numbers, "face");
  const auto turns = from_steps(in.block(bytes_of(faces, 4)), largest, "turns of faces");
  for (std::size_t f = 0; f < numbers.size(); ++f) level.faces.push_back({numbers[f], turns[f]});
  const auto read = [&](Grid<double>& grid, int width) {
    const Bytes planes = in.block(bytes_of(3 * vertices, width));
    grid = Grid<double>({vertices, 3});
    grid.samples() = from_planes(planes, width);
  };
  read(level.details, lossy ? 4 : 8);
  if (!lossy) read(level.remainder, 8);
  for (std::size_t k = 2; k < sizes.size(); ++k)
    level.attributes.push_back(in.block(static_cast<std::uint64_t>(sizes[k])));
  return level;
}

void check_sizes(GridStep step, const std::vector<MeshLevelDetails>& levels) {
  try {
    for (std::size_t i = 0; i < levels.size(); ++i) {
      if (i > 0) step = step.coarser();
      if (step.fine.rows > levels[i].vertices() / step.fine.cols ||
          step.fine.rows * step.fine.cols != levels[i].vertices())
        damaged("rows and columns of the grid");
    }
  } catch (const InvalidField& error) {
    damaged(error.what());
  }
}

}  // namespace

MeshDetailsFile decode_mesh_details(std::span<const std::uint8_t> bytes, const Unpack& unpack) {
  Reader in(bytes, unpack);
  if (in.kind() == details::raster_kind)
    throw InvalidDetails("these are the details of a raster, not of a mesh; restore a raster");
  if (in.kind() != details::mesh_kind) damaged("the header does not begin as one");
  MeshDetailsFile file;
  const std::string scheme(in.text("scheme"));
  if (scheme == "grid")
    file.grid = grid_step_of(in);
  else
    file.rule = rule_of(in, scheme);
  try {
    file.mode = parse_reverse_mode(in.text("mode"));
  } catch (const InvalidField& error) {
    damaged(error.what());
  }
  file.lossy = in.number("lossy", 0, 1) == 1;
  constexpr Index largest_checksum = 0xFFFFFFFFLL;
  file.coarse_faces = static_cast<std::uint32_t>(in.number("coarse_faces", 0, largest_checksum));
  file.coarse_positions =
      static_cast<std::uint32_t>(in.number("coarse_positions", 0, largest_checksum));
  const Index attributes = in.number("attributes", 0, 1000);
  for (Index i = 0; i < attributes; ++i) file.attributes.emplace_back(in.text("attribute"));
  const Index levels = in.number("levels", 0, 64);
  std::vector<std::vector<Index>> sizes;
  for (Index i = 0; i < levels; ++i)
    sizes.push_back(Reader::to_numbers(in.text("level"), "a level",
                                       2 + static_cast<std::size_t>(attributes), largest));
  if (!in.notes().empty()) damaged("notes in the header");
  for (std::size_t i = sizes.size(); i-- > 0;)
    file.levels.insert(file.levels.begin(), read_level(in, sizes[i], file.lossy));
  in.end();
  if (file.grid) check_sizes(*file.grid, file.levels);
  return file;
}

bool are_mesh_details(std::span<const std::uint8_t> bytes) {
  constexpr std::size_t prologue = 24;
  return bytes.size() > prologue + details::mesh_kind.size() &&
         std::equal(details::mesh_kind.begin(), details::mesh_kind.end(), bytes.begin() + prologue);
}

}  // namespace arete

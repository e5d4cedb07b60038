// SPDX-License-Identifier: MIT
#pragma once

#include "arete/reverse/details_envelope.h"
#include "arete/reverse/mesh_recover.h"

namespace arete {

/// What leads from a coarse mesh to the next finer one, without the coarse positions.
struct MeshLevelDetails {
  std::vector<Index> place;                     ///< see RecoveredMesh
  std::vector<RecoveredMesh::FacePlace> faces;  ///< see RecoveredMesh
  Grid<double> details;                         ///< x, y, z; one row a fine vertex
  Grid<double> remainder;                       ///< likewise; of no size when details are lossy
  /// Of attributes, what the coarse mesh does not hold: raw bytes, one entry for each name in
  /// MeshDetailsFile::attributes.
  std::vector<Bytes> attributes;

  [[nodiscard]] Index vertices() const { return static_cast<Index>(place.size()); }
};

/// All that a mesh's details file says.
struct MeshDetailsFile {
  MeshRule rule = MeshScheme::catmull_clark;  ///< without meaning when there is `grid`
  std::optional<GridStep> grid;               ///< the finest step of a grid mesh
  ReverseMode mode = ReverseMode::least_squares;
  bool lossy = false;                  ///< details were dropped and the rest rounded to float32
  std::uint32_t coarse_faces = 0;      ///< checksums of the coarse mesh's faces
  std::uint32_t coarse_positions = 0;  ///< and positions
  std::vector<std::string> attributes;
  std::vector<MeshLevelDetails> levels;  ///< the finest first

  /// The scheme, of meshes or of the catalogue, as text.
  [[nodiscard]] std::string scheme_text() const {
    return grid ? grid->scheme.text() : std::string(to_string(rule.scheme));
  }
};

/// The envelope of a details file (details_file.h), version 1, of kind "arete mesh details"; blocks
/// from the coarsest level to the finest: places, faces, turns, details, remainder, attributes.
[[nodiscard]] Bytes encode_mesh_details(const MeshDetailsFile& file, const Pack& pack = {});

/// Reads them back; no bytes make it crash or take more than some 1000 times their own size.
/// \throws InvalidDetails as decode_details, and for details of a raster.
[[nodiscard]] MeshDetailsFile decode_mesh_details(std::span<const std::uint8_t> bytes,
                                                  const Unpack& unpack = {});

/// Of which kind the bytes of a details file are; nothing is checked but their beginning.
[[nodiscard]] bool are_mesh_details(std::span<const std::uint8_t> bytes);

/// Of the numbers of vertices and of every face's corners.
[[nodiscard]] std::uint32_t checksum(const MeshFaces& mesh);

}  // namespace arete

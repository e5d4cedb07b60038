// SPDX-License-Identifier: MIT
#pragma once

namespace arete::vtk {

/// How the arrays of a VTK XML file are packed. All are written as raw appended binary with 64-bit
/// headers; every VTK since 5.10 (lz4: 8.1) and ParaView read them.
enum class Compression {
  none,  ///< fastest to map, largest
  lz4,   ///< as fast to write; a .vts or .vtp shrinks by a quarter, bare heights hardly
  zlib,  ///< the smallest (level 1), three to eight times slower to write
};

struct WriteOptions {
  Compression compression = Compression::lz4;
};

}  // namespace arete::vtk

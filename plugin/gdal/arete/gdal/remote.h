// SPDX-License-Identifier: MIT
#pragma once

#include <string>

namespace arete::gdal {

/// Whether a name would make GDAL ask a network: a remote virtual file system (`/vsicurl/`,
/// `/vsis3/`, ..., also inside `/vsizip/` and its kin), a URL (also inside `NETCDF:"..."`), or a
/// service such as `WMS:`.
[[nodiscard]] bool is_remote(const std::string& path);

/// From now on GDAL reads no network in this process, not even where a local file (a .vrt, say)
/// names a remote one; Raster refuses remote names with a message. To be called before the first
/// raster is opened; cannot be undone.
void forbid_remote_access();

/// From now on GDAL runs no other program and no code that a file brings along (GPSBabel, Python in
/// a .vrt) in this process, and opens no memory of the process by an address that a file names
/// (`MEM:::`).
void forbid_programs();

/// \throws RasterError if the name is remote and forbid_remote_access() was called. Whatever opens
/// a file by a name that a user gave calls it.
void refuse_remote(const std::string& path);

}  // namespace arete::gdal

// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace arete::cli {

/// \throws Failure if a GeoTIFF of `bytes` of samples cannot fit beside `path`: uncompressed when
/// the creation options say so, otherwise at the best ratio that real terrain reaches (1 : 50).
/// What turns out too large only while writing is found then, and removed.
void check_disk(const std::string& path, const std::vector<std::string>& creation_options,
                double bytes);

}  // namespace arete::cli

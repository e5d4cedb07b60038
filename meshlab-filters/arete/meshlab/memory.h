// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace arete::meshlab {

/// \throws InvalidField if a result of that many bytes does not fit into the memory that is free:
/// the system would rather kill the program than say no.
void check_memory(double bytes, double new_vertices);

}  // namespace arete::meshlab

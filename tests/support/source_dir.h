// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace arete::test {

/// The folder of the sources (data, documents, oracle records). Only this one object depends on where
/// the sources lie, so a compiler cache serves every checkout.
std::string source_dir();

}  // namespace arete::test

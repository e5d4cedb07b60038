// SPDX-License-Identifier: MIT
#include "support/source_dir.h"

std::string arete::test::source_dir() { return ARETE_SOURCE_DIR; }

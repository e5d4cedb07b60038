// SPDX-License-Identifier: MIT
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace arete::cli {

/// The verbs of a program that help shows.
[[nodiscard]] std::vector<const CLI::App*> visible_verbs(const CLI::App& program);

/// The spellings of an option (`-h`, `--help`); empty for a positional argument.
[[nodiscard]] std::vector<std::string> spellings(const CLI::Option& option);

/// Whether the option is followed by a value.
[[nodiscard]] bool takes_value(const CLI::Option& option);

/// The words the option accepts, where they are a fixed set; otherwise empty.
[[nodiscard]] std::vector<std::string> accepted_words(const CLI::Option& option);

}  // namespace arete::cli

// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once
#include <CLI/CLI.hpp>

#include "configuration/error.hpp"
#include "program/run_main.hpp"

namespace flowslide {

/// Reads the options of a benchmark. Throws FinishedEarly with the help text for --help, and ConfigurationError for a
/// wrong option.
inline void parse_options(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    throw FinishedEarly(app.help());
  } catch (const CLI::ParseError& error) {
    throw ConfigurationError(error.what());
  }
}

}  // namespace flowslide

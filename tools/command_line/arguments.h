// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>

namespace tzc::command_line {

/// A number from `least` to `most`: seconds, rates. CLI::Range lets NaN pass, with which no comparison is true.
CLI::Validator number_between(double least, double most);

/// A whole number of bytes, as 4k and 64MB (powers of 1024) too; CLI::AsSizeValue makes 16 EB of -1. Sets the option to the number.
CLI::Validator size_in_bytes();

/// A file that can be written, as far as one can tell before the work whose result goes there. A folder is none, nor is `-`.
CLI::Validator file_to_write();

/// What a shell's empty variable has left of an argument: nothing, which options take for "not given", or `--cache-dir=`, for whose value
/// CLI11 takes the next argument. For the user; empty: no such argument.
std::string why_incomplete(int argc, const char* const* argv);

/// Parses the command line, and prints help, the version, or what is wrong. The exit status where the command is over
/// with that: 2 after a mistake. Mistakes that only several options together make: in app.callback.
std::optional<int> parse(CLI::App& app, int argc, const char* const* argv);

}  // namespace tzc::command_line

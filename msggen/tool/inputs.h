// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parse/library.h"
#include "tool/commands.h"

namespace tzc::msggen {

/// A folder that is named and is not there: a fault, or one without messages. genmsg names a folder for every package that has declared
/// messages, and whoever uses one that is not there is told.
enum class MissingFolder { fault, empty };

/// Reads "PKG:DIR" arguments; one without a colon is reported.
SearchPath parse_includes(const std::vector<std::string>& includes, Diagnostics& diagnostics,
                          MissingFolder missing = MissingFolder::fault);

/// The packages of this machine.
PackageIndex installed_packages();

/// Reports a fault that belongs to no file.
void report_usage(std::string message, std::string hint, Diagnostics& diagnostics);

/// Prints all faults; the exit status that they mean.
int finish(const Diagnostics& diagnostics, Console console);

}  // namespace tzc::msggen

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "parse/library.h"
#include "tool/commands.h"

namespace tzc::msggen {

/// Reads "PKG:DIR" arguments; one without a colon or with a folder that isn't there is reported.
SearchPath parse_includes(const std::vector<std::string>& includes, Diagnostics& diagnostics);

/// The packages of this machine.
PackageIndex installed_packages();

/// Reports a fault that belongs to no file.
void report_usage(std::string message, std::string hint, Diagnostics& diagnostics);

/// Prints all faults; the exit status that they mean.
int finish(const Diagnostics& diagnostics, Console console);

}  // namespace tzc::msggen

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "emit/header.h"
#include "model/diagnostic.h"

namespace tzc::msggen {

struct OutputOptions {
  std::string folder;
  /// Leave files alone whose content would not change, so that nothing is compiled again; otherwise every
  /// file gets a new time, as a build tool expects of a command that it ran.
  bool if_changed = false;
};

/// Writes all headers or none (see Staging). Returns how many files were replaced.
std::size_t write_headers(const std::vector<Header>& headers, const OutputOptions& options,
                          Diagnostics& diagnostics);

}  // namespace tzc::msggen

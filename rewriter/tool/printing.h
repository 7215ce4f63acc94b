// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "port/package_port.h"
#include "tool/parse_options.h"

namespace tzc::rewriter {

/// How a run ends.
enum Status { nothing_left = 0, work_left = 1, failed = 2 };

struct Outcome {
  Status status = nothing_left;
  std::string undo;  ///< the command that takes back what was written; empty: none
};

/// The report, what to do next, and the diff of a dry run. The report goes to standard output unless the diff
/// does.
void print_reports(const Options& options, const std::vector<PackagePort>& ports, const Outcome& outcome);

/// Whether a site of the package stays on TCPROS, though nothing asks for that.
bool has_refusal(const PackagePort& port);

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "options.h"

namespace tzc {
namespace bench {

/// The command line of `tzc-bench paper`.
struct PaperOptions {
  Options cells;
  std::string output = "tzc-paper";
  bool plots = true;
  std::vector<std::string> types;   // folders of message packages to count
  std::vector<std::string> effort;  // packages to count the rewriter's lines in
  bool load = false;                // every case also on a busy machine
  bool real_time = true;            // the cases of TZC-RT, too; by default where no contenders are chosen
  bool wants_real_time = false;     // the command line says so
  bool dry_run = false;             // the plan is printed, nothing is measured or written
  std::string publish;              // a folder that gets page, tables and plots, too; empty: none
  bool fills = false;               // allocating and filling belong to the span of a latency
};

/// Sets the options that the command line names. The result is parse's.
std::optional<int> parse_paper_options(int argc, char** argv, PaperOptions& options);

}  // namespace bench
}  // namespace tzc

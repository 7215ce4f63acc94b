// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "options.h"

namespace tzc {
namespace bench {

/// The command line of `tzc-bench paper`.
struct PaperOptions {
  Options cells;
  std::string output = "tzc-paper";
  bool plots = true;
};

/// Sets the options that the command line names. The result is parse's.
std::optional<int> parse_paper_options(int argc, char** argv, PaperOptions& options);

}  // namespace bench
}  // namespace tzc

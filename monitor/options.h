// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace tzc::monitor {

struct Options {
  bool once = false;
  bool json = false;
  double interval_s = 1;
  std::string topic;                ///< empty: all
  std::vector<std::string> why;     ///< node and topic; empty: a table is wanted
  std::vector<std::string> traces;  ///< files to join; empty: as above
};

/// Null: the program ends with `status` (help was printed, or the options are wrong).
std::optional<Options> parse_options(int argc, char** argv, int& status);

}  // namespace tzc::monitor

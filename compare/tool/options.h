// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "engine/comparison.h"
#include "engine/verdict.h"
#include "run/run.h"

namespace tzc::compare {

struct Options {
  std::string original, port;
  Input input;
  Recorded recorded;
  LeftOut left_out;
  Rules rules;
  int runs = 2;      ///< of the original
  std::string json;  ///< file, "-" for standard output
  std::string keep;  ///< folder for recordings and logs; empty: they are deleted
  std::string scratch;
  bool is_quiet = false;
};

/// Null: the program ends with `status` (help was printed, or the options are wrong).
std::optional<Options> parse_options(int argc, char** argv, int& status);

}  // namespace tzc::compare

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "edits/expected.h"
#include "report/model.h"

namespace tzc::rewriter {

enum class Action { diff, apply, out_dir, check };

/// The command line, checked.
struct Options {
  Action action = Action::diff;
  std::vector<std::string> packages;  ///< as given
  std::string build_dir;              ///< -p; empty: search
  std::string out_dir;
  std::vector<std::string> reports;  ///< files; the extension is known to be .json, .sarif or .html
  std::string baseline;
  std::vector<std::string> only, except;  ///< "topic=GLOB", "type=GLOB", "file=GLOB"
  Level level = Level::zero_copy;
  OnExhausted on_exhausted = OnExhausted::deliver;
  std::optional<std::uint64_t> mem_size;
  std::vector<std::string> bags;
  bool dual = false;
  bool force = false;
  bool quiet = false;
  unsigned jobs = 0;
  std::vector<std::string> tzc_includes;
};

/// What to do instead of a run: print this and end with that status (--help, --explain, a mistake in the
/// arguments).
struct Answer {
  std::string text;
  int status = 0;
};

std::variant<Options, Answer> parse_options(int argc, const char* const* argv);

/// "4096", "64K", "64MB", "1GiB"; K, M and G are powers of 1024.
std::optional<std::uint64_t> parse_size(const std::string& text);

}  // namespace tzc::rewriter

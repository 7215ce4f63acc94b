// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "model/expected.h"
#include "model/report.h"
#include "tool/answer.h"

namespace tzc::rewriter {

enum class Action { diff, apply, out_dir, check };

/// How far a port is verified beyond Clang and the package's own compiler: not at all, by configuring a scratch
/// copy of the workspace with the edited build files, or by building it as well.
enum class Verify { source, syntax, build };

/// The command line, checked.
struct Options {
  Action action = Action::diff;
  std::string command;                ///< as typed, for reports
  std::vector<std::string> packages;  ///< as given
  std::string build_dir;              ///< -p; empty: search
  std::string out_dir;
  std::vector<std::string> reports;  ///< files; the extension is known to be .json, .sarif or .html
  std::string baseline;
  std::string undo;  ///< where --apply saves what takes it back; empty: a place of the tool's own
  std::vector<std::string> only, except;  ///< "topic=GLOB", "type=GLOB", "file=GLOB"
  std::vector<std::string> dead_files;    ///< globs: nothing compiles them any more, whatever is configured
  Level level = Level::zero_copy;
  OnExhausted on_exhausted = OnExhausted::deliver;
  std::uint64_t small = 4096;  ///< bytes of arrays below which a message stays as it is
  std::optional<std::uint64_t> mem_size;
  std::vector<std::string> bags;
  Verify verify = Verify::syntax;
  bool strict = false;  ///< a source that does not parse refuses its package
  bool dual = false;
  bool force = false;
  bool quiet = false;
  std::string cache_dir;  ///< of results; empty: none are kept
  unsigned jobs = 0;
  std::vector<std::string> tzc_includes;
  bool change_exported = false;  ///< the packages named are taken for all users of their exported headers
};

std::variant<Options, Answer> parse_options(int argc, const char* const* argv);

/// "4096", "64K", "64MB", "1GiB"; K, M and G are powers of 1024.
std::optional<std::uint64_t> parse_size(const std::string& text);

}  // namespace tzc::rewriter

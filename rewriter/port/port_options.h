// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/report.h"

namespace tzc::rewriter {

enum class Action { diff, apply, out_dir, check };

/// How far a port is verified beyond Clang and the package's own compiler: not at all, by configuring a scratch
/// copy of the workspace with the edited build files, or by building it as well.
enum class Verify { source, syntax, build };

/// What the user asks of a port, checked.
struct PortOptions {
  Action action = Action::diff;
  std::vector<std::string> packages;  ///< as given
  std::string build_dir;              ///< -p; empty: search
  std::string out_dir;
  std::string undo;  ///< where --apply saves what takes it back; empty: a place of the tool's own
  std::vector<std::string> only, except;  ///< "topic=GLOB", "type=GLOB", "file=GLOB"
  std::vector<std::string> dead_files;    ///< globs: nothing compiles them any more, whatever is configured
  Level level = Level::zero_copy;
  OnExhausted on_exhausted = OnExhausted::deliver;
  std::uint64_t small = 4096;  ///< bytes of arrays below which a message stays as it is
  std::optional<std::uint64_t> mem_size;
  Verify verify = Verify::syntax;
  bool strict = false;  ///< a source that does not parse refuses its package
  bool dual = false;
  bool force = false;
  std::string cache_dir;  ///< of results; empty: none are kept
  unsigned jobs = 0;
  std::vector<std::string> tzc_includes;
  bool change_exported = false;  ///< the packages named are taken for all users of their exported headers
};

}  // namespace tzc::rewriter

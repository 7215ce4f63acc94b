// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace tzc::rewriter {

enum class LineChange { same, removed, added };

/// One line of a comparison, with its line ending. A removed line has no new number, an added one no old
/// number (0).
struct DiffLine {
  LineChange change = LineChange::same;
  std::string_view text;  ///< points into the compared contents
  unsigned old_number = 0;
  unsigned new_number = 0;
};

/// A shortest line diff (Myers). Lines end after '\n'; CRLF stays part of the line.
std::vector<DiffLine> diff_lines(std::string_view before, std::string_view after);

struct DiffStat {
  unsigned files = 0, added = 0, removed = 0;
  DiffStat& operator+=(const DiffStat& other);
};

struct FileDiff {
  std::string text;  ///< what `git apply` and `patch -p1` take; empty when nothing differs
  DiffStat stat;
};

/// `git_paths`: `path` is relative to the top of a git repository, so that `git apply` works in any of its
/// folders; otherwise to the folder where the patch is applied.
FileDiff unified_diff(const std::string& path, std::string_view before, std::string_view after,
                      bool git_paths);

}  // namespace tzc::rewriter

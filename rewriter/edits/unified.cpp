// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "edits/diff.h"

namespace tzc::rewriter {
namespace {

constexpr std::size_t context = 3;

struct Hunk {
  std::size_t begin, end;  // of the diff's lines
};

/// Changes that are at most two contexts apart share a hunk.
std::vector<Hunk> hunks_of(const std::vector<DiffLine>& lines) {
  std::vector<Hunk> hunks;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (lines[i].change == LineChange::same) continue;
    const std::size_t begin = i < context ? 0 : i - context;
    const std::size_t end = std::min(lines.size(), i + 1 + context);
    if (!hunks.empty() && begin <= hunks.back().end)
      hunks.back().end = end;
    else
      hunks.push_back({begin, end});
  }
  return hunks;
}

std::string range(std::size_t start, std::size_t count) {
  // An empty range names the line before it.
  const std::size_t shown = count == 0 ? start - 1 : start;
  return std::to_string(shown) + (count == 1 ? "" : "," + std::to_string(count));
}

std::string hunk_text(const std::vector<DiffLine>& lines, Hunk hunk) {
  std::size_t old_start = 1, new_start = 1, old_count = 0, new_count = 0;
  for (std::size_t i = 0; i < hunk.begin; ++i) {
    old_start += lines[i].change != LineChange::added;
    new_start += lines[i].change != LineChange::removed;
  }
  std::string body;
  for (std::size_t i = hunk.begin; i < hunk.end; ++i) {
    old_count += lines[i].change != LineChange::added;
    new_count += lines[i].change != LineChange::removed;
    body += " -+"[static_cast<int>(lines[i].change)];
    body += lines[i].text;
    if (body.back() != '\n') body += "\n\\ No newline at end of file\n";
  }
  return "@@ -" + range(old_start, old_count) + " +" + range(new_start, new_count) + " @@\n" + body;
}

std::string header(const std::string& path, bool git_paths) {
  // A tab ends a name with spaces, as git and diff write it.
  const std::string tab = path.find(' ') == std::string::npos ? "" : "\t";
  const std::string names = "--- a/" + path + tab + "\n+++ b/" + path + tab + "\n";
  return git_paths ? "diff --git a/" + path + " b/" + path + "\n" + names : names;
}

}  // namespace

DiffStat& DiffStat::operator+=(const DiffStat& other) {
  files += other.files;
  added += other.added;
  removed += other.removed;
  return *this;
}

FileDiff unified_diff(const std::string& path, std::string_view before, std::string_view after,
                      bool git_paths) {
  FileDiff diff;
  if (before == after) return diff;
  const std::vector<DiffLine> lines = diff_lines(before, after);
  diff.text = header(path, git_paths);
  for (const Hunk& hunk : hunks_of(lines)) diff.text += hunk_text(lines, hunk);
  diff.stat.files = 1;
  for (const DiffLine& line : lines) {
    diff.stat.added += line.change == LineChange::added;
    diff.stat.removed += line.change == LineChange::removed;
  }
  return diff;
}

}  // namespace tzc::rewriter

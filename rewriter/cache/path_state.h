// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <time.h>

#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>

#include "model/file_accesses.h"

namespace tzc::rewriter {

/// A text to a short one that differs when it does.
using Digest = std::function<std::string(std::string_view)>;

/// Files and folders as a run may depend on them, as texts: equal texts mean that it would see the same. Symbolic
/// links are followed, and where they lead is part of the text.
class PathStates {
 public:
  /// `omitted`: folders that are not part of trees (build trees). Version control's folders never are.
  explicit PathStates(Digest digest, std::set<std::string> omitted = {})
      : digest_(std::move(digest)), omitted_(std::move(omitted)) {}

  /// Thread-safe.
  std::string of(const std::string& path, Access access) const;

 private:
  std::string content(const std::string& path) const;
  std::string names(const std::string& folder, int depth) const;
  std::string tree(const std::string& folder) const;
  std::string tree_file(const std::string& file) const;

  Digest digest_;
  std::set<std::string> omitted_;
};

/// What was changed at or after a moment of the system's coarse clock. The change times of inodes tell; nothing but the clock
/// itself can set them back.
class ChangesSince {
 public:
  explicit ChangesSince(const timespec& moment) : moment_(moment) {}

  /// Whether they concern what an access depends on: the file, what is in the folder, or, where nothing is, the folder that it
  /// would be in.
  bool concern(const std::string& path, Access access);

 private:
  bool is_changed(const std::string& path) const;
  bool concern_absent(const std::string& path);

  timespec moment_;
  std::map<std::string, bool>
      without_;  ///< a folder in which something is not -> whether that may have been otherwise
};

/// Larger files of trees count by size, times and identity instead of by content: they are data (recordings, models).
constexpr std::size_t largest_read = 8u << 20;

}  // namespace tzc::rewriter

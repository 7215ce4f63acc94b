// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mutex>
#include <set>
#include <string>
#include <utility>

namespace tzc::rewriter {

/// How much of a path a result depends on.
enum class Access {
  content,  ///< of a file, or that nothing is there
  names,    ///< of the entries of a folder
  names2,   ///< of the entries of a folder, and of those one level below
  tree,     ///< content of every file below a folder
};

/// What a run has looked at outside of itself, found or not: what its result depends on. Thread-safe.
class FileAccesses {
 public:
  using Entry = std::pair<std::string, Access>;

  /// `path`: absolute.
  void note(const std::string& path, Access access = Access::content) {
    const std::lock_guard<std::mutex> lock(mutex_);
    entries_.emplace(path, access);
  }

  /// Something was read that cannot be followed: the result must not be kept.
  void give_up() {
    const std::lock_guard<std::mutex> lock(mutex_);
    complete_ = false;
  }

  /// For when the run is over.
  const std::set<Entry>& entries() const { return entries_; }
  bool is_complete() const { return complete_; }

 private:
  std::mutex mutex_;
  std::set<Entry> entries_;
  bool complete_ = true;
};

}  // namespace tzc::rewriter

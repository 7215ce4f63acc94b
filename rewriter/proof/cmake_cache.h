// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

struct CacheEntry {
  std::string name, type, value;
};

/// A CMakeCache.txt.
class CmakeCache {
 public:
  CmakeCache() = default;
  CmakeCache(std::string folder, const std::string& text);

  /// The cache of a folder or of the nearest one above it; empty: there is none.
  static CmakeCache nearest(const std::string& folder);

  bool empty() const { return folder_.empty(); }
  /// Where it lies: the top of the build tree.
  const std::string& folder() const { return folder_; }
  const std::vector<CacheEntry>& entries() const { return entries_; }
  /// Empty: there is no such entry, or what it names was not found.
  std::string value(const std::string& name) const;

 private:
  std::string folder_;
  std::vector<CacheEntry> entries_;
};

/// A command for an initial cache (cmake -C) that sets the entry.
std::string cache_command(const CacheEntry& entry);

}  // namespace tzc::rewriter

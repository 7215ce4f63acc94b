// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace tzc::rewriter {

/// A folder, and the folder that stands for it.
struct FolderMapping {
  std::string from, to;
};

/// Rewrites paths in commands and sources: those below a mapping's `from` become paths below its `to`; paths
/// below a folder of `except` stay. The first matching mapping applies.
class PathMap {
 public:
  void add(std::string from, std::string to);
  void except(std::string folder);

  /// Every path in a word of a command line: "-I/ws/src/demo/include", "-DDATA=\"/ws/src/demo\"".
  std::string in_word(const std::string& word) const;
  /// The paths of #include directives in a source.
  std::string in_includes(const std::string& source) const;

 private:
  bool applies(const std::string& text, std::size_t at, const std::string& folder) const;

  std::vector<FolderMapping> mappings_;
  std::vector<std::string> except_;
};

}  // namespace tzc::rewriter

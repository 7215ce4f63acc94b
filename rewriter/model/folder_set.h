// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tzc::rewriter {

/// Whether a path lies in a folder, at any depth.
inline bool is_below(const std::string& path, const std::string& folder) {
  return path.size() > folder.size() && path.compare(0, folder.size(), folder) == 0 &&
         (folder.back() == '/' || path[folder.size()] == '/');
}

/// Folders of which none lies in another, such as those of the packages that are ported as one. Paths are absolute and
/// canonical; "/" holds every file.
class FolderSet {
 public:
  FolderSet() = default;
  FolderSet(std::string folder) : folders_{std::move(folder)} {}
  explicit FolderSet(std::vector<std::string> folders) : folders_(std::move(folders)) {}

  auto begin() const { return folders_.begin(); }
  auto end() const { return folders_.end(); }

  /// The folder in which a file lies. Null: in none.
  const std::string* of(const std::string& path) const {
    const auto found = std::find_if(folders_.begin(), folders_.end(),
                                    [&](const std::string& folder) { return is_below(path, folder); });
    return found == folders_.end() ? nullptr : &*found;
  }
  bool hold(const std::string& path) const { return of(path) != nullptr; }

  /// The path as seen from its folder; one that lies in none stays as it is.
  std::string relative(const std::string& path) const {
    const std::string* folder = of(path);
    return folder == nullptr ? path : path.substr(folder->size() + (folder->back() == '/' ? 0 : 1));
  }

 private:
  std::vector<std::string> folders_;
};

}  // namespace tzc::rewriter

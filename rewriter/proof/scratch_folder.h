// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "model/expected.h"

namespace tzc::rewriter {

/// A folder of this run's own below the system's temporary folder, removed with the object. A lock that the
/// process holds on it tells folders in use from those that a killed run left; the latter are removed by the
/// next run of the same user.
class ScratchFolder {
 public:
  static Expected<ScratchFolder> make();

  ScratchFolder(ScratchFolder&& other) noexcept : path_(std::move(other.path_)), lock_(other.lock_) {
    other.path_.clear();
    other.lock_ = -1;
  }
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  /// Absolute, canonical.
  const std::string& path() const { return path_; }
  std::string operator/(const std::string& name) const { return path_ + "/" + name; }

 private:
  ScratchFolder(std::string path, int lock) : path_(std::move(path)), lock_(lock) {}
  std::string path_;
  int lock_;  ///< descriptor of the locked file
};

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "interruption/interruption.h"
#include "model/expected.h"

namespace tzc::rewriter {

/// A folder of this run's own, removed with the object, or when the process is interrupted. A lock that the
/// process holds on it tells folders in use from those that a killed run left; the latter are removed by the
/// next run of the same user.
class ScratchFolder {
 public:
  /// Below the system's temporary folder.
  static Expected<ScratchFolder> make();
  /// In a folder that is there, by a name that begins so.
  static Expected<ScratchFolder> make_in(const std::string& parent, const std::string& prefix);

  ScratchFolder(ScratchFolder&& other) noexcept : folder_(std::move(other.folder_)), lock_(other.lock_) {
    other.lock_ = -1;
  }
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  ~ScratchFolder();

  /// Absolute, canonical.
  const std::string& path() const { return folder_.folder(); }
  std::string operator/(const std::string& name) const { return path() + "/" + name; }

 private:
  ScratchFolder(std::string path, int lock) : folder_(std::move(path)), lock_(lock) {}
  RemovedWhenInterrupted folder_;
  int lock_;  ///< descriptor of the locked file
};

}  // namespace tzc::rewriter

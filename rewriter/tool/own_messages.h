// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "edits/expected.h"

namespace tzc::rewriter {

/// The TZC headers of messages that the package or its workspace defines, made by tzc-msggen in a folder that
/// lives as long as the object. Empty where there are none.
class OwnMessages {
 public:
  static Expected<OwnMessages> generate(const std::string& package_dir, const std::string& build_dir);

  OwnMessages(OwnMessages&& other) noexcept
      : folder_(std::move(other.folder_)), packages_(std::move(other.packages_)) {
    other.folder_.clear();
  }
  OwnMessages& operator=(OwnMessages&&) = delete;
  ~OwnMessages();

  std::vector<std::string> include_dirs() const;

  /// The workspace's message packages and their folders, the package itself among them.
  const std::map<std::string, std::string>& packages() const { return packages_; }

 private:
  OwnMessages() = default;
  std::string folder_;
  std::map<std::string, std::string> packages_;
};

}  // namespace tzc::rewriter

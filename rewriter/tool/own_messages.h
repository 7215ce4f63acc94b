// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "edits/expected.h"

namespace tzc::rewriter {

/// The TZC headers of messages that the package or its workspace defines, made by tzc-msggen in a folder that
/// lives as long as the object. Empty where there are none.
class OwnMessages {
 public:
  static Expected<OwnMessages> generate(const std::string& package_dir);

  OwnMessages(OwnMessages&& other) noexcept : folder_(std::move(other.folder_)) { other.folder_.clear(); }
  OwnMessages& operator=(OwnMessages&&) = delete;
  ~OwnMessages();

  std::vector<std::string> include_dirs() const;

 private:
  OwnMessages() = default;
  std::string folder_;
};

}  // namespace tzc::rewriter

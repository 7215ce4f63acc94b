// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "model/expected.h"
#include "proof/scratch_folder.h"

namespace tzc::rewriter {

/// Where generate() reads message definitions: folders of the workspace and of installed packages, and the generator.
struct MessageSources {
  std::vector<std::string> folders;
  std::string generator;
};
MessageSources message_sources(const std::string& package_dir, const std::string& build_dir);

/// The TZC headers of messages that the package or its workspace defines, made by tzc-msggen in a folder that
/// lives as long as the object. Empty where there are none.
class OwnMessages {
 public:
  static Expected<OwnMessages> generate(const std::string& package_dir, const std::string& build_dir);

  std::vector<std::string> include_dirs() const;

  /// The workspace's message packages and their folders, the package itself among them.
  const std::map<std::string, std::string>& packages() const { return packages_; }

 private:
  OwnMessages() = default;
  std::optional<ScratchFolder> folder_;
  std::map<std::string, std::string> packages_;
};

}  // namespace tzc::rewriter

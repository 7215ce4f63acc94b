// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "model/expected.h"
#include "proof/scratch_folder.h"

namespace tzc::rewriter {

/// Where generate() reads message definitions: folders of the workspace and of installed packages, and the generator.
struct MessageSources {
  std::set<std::string> folders;
  std::string generator;
};
MessageSources message_sources(const std::string& package_dir, const std::string& build_dir);

/// The TZC headers of messages that packages or their workspace define, made by tzc-msggen in a folder that
/// lives as long as the object. Empty where there are none.
class OwnMessages {
 public:
  /// `build_dirs`: of each package. An error when a message of one of them is not accepted.
  static Expected<OwnMessages> generate(const std::map<std::string, std::string>& build_dirs);

  std::vector<std::string> include_dirs() const;

  /// The workspace's message packages and their folders, the packages themselves among them.
  const std::map<std::string, std::string>& packages() const { return packages_; }

 private:
  OwnMessages() = default;
  std::optional<ScratchFolder> folder_;
  std::map<std::string, std::string> packages_;
};

}  // namespace tzc::rewriter

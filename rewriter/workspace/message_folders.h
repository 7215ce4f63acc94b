// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <set>
#include <string>

namespace tzc::rewriter {

/// The folders with the .msg files of packages, by name.
using MessageFolders = std::map<std::string, std::set<std::filesystem::path>>;

/// Those of the workspace's message packages (`workspace`: name -> folder), then of all packages that these do not hide: what
/// CMake has found for the builds, what lies beside that, and what the environment names. Only folders that are there.
MessageFolders message_folders(const std::map<std::string, std::string>& workspace,
                               const std::set<std::string>& build_dirs);

/// The share folders of the devel spaces that the builds make.
std::set<std::filesystem::path> devel_shares(const std::set<std::string>& build_dirs);

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// What genmsg writes of a package's definitions when CMake configures it, into share/PKG/cmake of the devel space: whoever
// generates from them as well has the same definitions, wherever add_message_files() took them from.

#include <filesystem>
#include <set>
#include <string>

namespace tzc::rewriter {

/// Where the .msg files lie, those of its actions too (genmsg's pkg-msg-paths.cmake.develspace.in). Of a package that is
/// installed, genmsg says nothing that names a folder.
std::set<std::string> genmsg_folders(const std::filesystem::path& share, const std::string& package);

/// The .msg and .srv files that become code (genmsg's pkg-msg-extras.cmake.in), of those that are there; actions have become
/// messages. Empty: genmsg has not seen the package there.
std::set<std::string> genmsg_definitions(const std::filesystem::path& share, const std::string& package);

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace tzc::msggen {

/// What is in a folder, sorted; nothing if it cannot be read.
std::vector<std::filesystem::path> entries(const std::filesystem::path& folder);

/// Whether the path is that of a folder, links followed.
bool is_folder(const std::filesystem::path& path);

/// Shows `visit` the folder and those below it, as long as it says to go on below; not hidden ones. Follows
/// symbolic links as rospack and catkin do, but after all else, so that a folder's own place comes before a
/// link to it; shows none twice, which ends cycles.
void walk_folders(const std::string& folder, const std::function<bool(const std::string& folder)>& visit);

}  // namespace tzc::msggen

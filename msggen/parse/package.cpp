// SPDX-License-Identifier: BSD-3-Clause
#include "parse/package.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "parse/folders.h"
#include "parse/source.h"
#include "parse/text.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

fs::path genmsg_file(const fs::path& package_directory) {
  return package_directory / "cmake" / (package_directory.filename().string() + "-msg-paths.cmake");
}

std::vector<std::string> with_folders_below(const std::string& folder) {
  std::vector<std::string> folders;
  walk_folders(folder, [&](const std::string& shown) {
    folders.push_back(shown);
    return true;
  });
  return folders;
}

std::vector<std::string> files_in(const std::vector<std::string>& folders, const char* extension) {
  std::vector<std::string> files;
  for (const std::string& folder : folders) {
    for (const fs::path& path : entries(folder)) {
      if (path.extension() == extension && is_file(path.string())) files.push_back(path.string());
    }
  }
  return files;
}

}  // namespace

bool has_genmsg_file(const std::string& package_directory) {
  return is_file(genmsg_file(package_directory).string());
}

// _prepend_path("${PKG_DIR}/.." "msg;messages" PKG_MSG_INCLUDE_DIRS UNIQUE)
std::vector<std::string> folders_named_by_genmsg(const std::string& package_directory) {
  std::ifstream in(genmsg_file(package_directory));
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  static const std::regex call("_prepend_path\\s*\\(\\s*\"[^\"]*\"\\s+\"([^\"]*)\"");
  std::vector<std::string> folders;
  std::smatch match;
  if (!std::regex_search(text, match, call)) return folders;
  for (const std::string& name : split(match[1].str(), ';')) {
    const std::string folder = (fs::path(package_directory) / name).lexically_normal().string();
    const bool is_new = std::find(folders.begin(), folders.end(), folder) == folders.end();
    if (is_new && is_folder(folder)) folders.push_back(folder);
  }
  return folders;
}

std::vector<std::string> Package::message_directories() const {
  const std::vector<std::string> named = folders_named_by_genmsg(directory);
  std::vector<std::string> folders;
  if (named.empty() || is_folder(directory + "/msg")) folders = with_folders_below(directory + "/msg");
  for (const std::string& folder : named) {
    if (std::find(folders.begin(), folders.end(), folder) == folders.end()) folders.push_back(folder);
  }
  return folders;
}

std::vector<std::string> Package::definition_files() const {
  std::vector<std::string> files = files_in(message_directories(), ".msg");
  std::set<std::string> messages;
  for (const std::string& file : files) messages.insert(fs::path(file).stem().string());
  const auto services = files_in(with_folders_below(directory + "/srv"), ".srv");
  files.insert(files.end(), services.begin(), services.end());
  for (const std::string& action : files_in(with_folders_below(directory + "/action"), ".action")) {
    if (!messages.count(fs::path(action).stem().string() + "Action")) files.push_back(action);
  }
  return files;
}

}  // namespace tzc::msggen

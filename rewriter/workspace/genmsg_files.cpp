// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/genmsg_files.h"

#include <vector>

#include "buildfiles/cmake_values.h"
#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

CmakeValues values_of(const fs::path& share, const std::string& package, const char* file) {
  CmakeValues values;
  const fs::path path = share / package / "cmake" / (package + file);
  const Expected<std::string> content = read_file(path);
  if (!content) return values;
  const Expected<std::vector<CmakeCommand>> commands = parse_cmake(*content, path);
  if (!commands) return values;
  for (const CmakeCommand& command : *commands) values.learn(command);
  return values;
}

}  // namespace

std::set<std::string> genmsg_folders(const fs::path& share, const std::string& package) {
  return values_of(share, package, "-msg-paths.cmake").expand("${" + package + "_MSG_INCLUDE_DIRS}");
}

std::set<std::string> genmsg_definitions(const fs::path& share, const std::string& package) {
  const CmakeValues values = values_of(share, package, "-msg-extras.cmake");
  std::set<std::string> files;
  std::error_code none;
  for (const char* kind : {"_MESSAGE_FILES", "_SERVICE_FILES"})
    for (const std::string& file : values.expand("${" + package + kind + "}"))
      if (fs::path(file).is_absolute() && fs::is_regular_file(file, none)) files.insert(file);
  return files;
}

}  // namespace tzc::rewriter

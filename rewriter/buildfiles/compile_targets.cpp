// SPDX-License-Identifier: BSD-3-Clause
#include "buildfiles/compile_targets.h"

#include <filesystem>
#include <nlohmann/json.hpp>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
using nlohmann::json;
namespace {

/// "NAME" of ".../CMakeFiles/NAME.dir/...", wherever that stands in the entry's output or command.
std::string target_in(const std::string& text) {
  static const std::string before = "CMakeFiles/", after = ".dir/";
  const std::size_t end = text.rfind(after);
  if (end == std::string::npos) return "";
  const std::size_t begin = text.rfind(before, end);
  if (begin == std::string::npos) return "";
  return text.substr(begin + before.size(), end - begin - before.size());
}

std::string command_of(const json& entry) {
  if (entry.contains("output")) return entry["output"];
  if (entry.contains("command")) return entry["command"];
  std::string joined;
  for (const json& argument : entry.at("arguments")) joined += argument.get<std::string>() + " ";
  return joined;
}

std::string file_of(const json& entry) {
  const fs::path file = entry.at("file").get<std::string>();
  const fs::path absolute = file.is_absolute() ? file : entry.at("directory").get<std::string>() / file;
  std::error_code failed;
  const fs::path canonical = fs::canonical(absolute, failed);
  return failed ? absolute.lexically_normal() : canonical;
}

template <class Visit>
Expected<void> each_entry(const std::string& build_dir, Visit visit) {
  const std::string path = build_dir + "/compile_commands.json";
  const Expected<std::string> text = read_file(path);
  if (!text) return text.error();
  try {
    for (const json& entry : json::parse(*text)) visit(entry);
  } catch (const json::exception& broken) {
    return Error{std::string("is not a compilation database: ") + broken.what(), path,
                 "configure the workspace again"};
  }
  return {};
}

}  // namespace

Expected<std::map<std::string, std::set<std::string>>> targets_of_files(const std::string& build_dir) {
  std::map<std::string, std::set<std::string>> targets;
  const Expected<void> read = each_entry(build_dir, [&](const json& entry) {
    if (const std::string target = target_in(command_of(entry)); !target.empty())
      targets[file_of(entry)].insert(target);
  });
  if (!read) return read.error();
  return targets;
}

Expected<std::set<std::string>> compiled_files(const std::string& build_dir) {
  std::set<std::string> files;
  const Expected<void> read = each_entry(build_dir, [&](const json& entry) { files.insert(file_of(entry)); });
  if (!read) return read.error();
  return files;
}

}  // namespace tzc::rewriter

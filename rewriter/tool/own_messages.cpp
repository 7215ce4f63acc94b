// SPDX-License-Identifier: BSD-3-Clause
#include "tool/own_messages.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

#include "buildfiles/cmake_file.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "proof/cmake_cache.h"
#include "proof/compiler_reads.h"
#include "proof/process.h"
#include "tool/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

std::vector<std::string> definitions(const fs::path& package) {
  std::vector<std::string> files;
  for (const char* kind : {"msg", "srv", "action"}) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(package / kind, none))
      if (entry.path().extension() == std::string(".") + kind) files.push_back(entry.path());
  }
  return files;
}

/// Message packages of the workspace by name, the package itself among them.
std::map<std::string, fs::path> message_packages(const std::string& package_dir) {
  std::map<std::string, fs::path> found;
  Expected<std::vector<std::string>> all = find_packages_at(source_space(package_dir));
  if (!all) all = std::vector<std::string>{package_dir};
  for (const std::string& folder : *all)
    if (!definitions(folder).empty())
      if (const Expected<PackageXml> package = read_package_xml(folder)) found[package->name] = folder;
  return found;
}

std::string generator() {
  const fs::path beside = fs::path(own_folder()) / "tzc-msggen";
  return fs::exists(beside) ? beside.string() : "tzc-msggen";
}

/// The words of a CMake list that is given as one argument.
std::vector<fs::path> split_list(const std::string& list) {
  std::vector<fs::path> words;
  for (std::size_t at = 0; at < list.size();) {
    const std::size_t end = std::min(list.find(';', at), list.size());
    if (end > at) words.emplace_back(list.substr(at, end - at));
    at = end + 1;
  }
  return words;
}

/// What genmsg says of a package in a devel space (pkg-msg-paths.cmake.develspace.in), whose messages stay with its
/// sources; those of its actions are made in the devel space. Empty for one that is installed.
std::vector<fs::path> devel_message_folders(const fs::path& share, const std::string& package) {
  const fs::path file = share / package / "cmake" / (package + "-msg-paths.cmake");
  const Expected<std::string> content = read_file(file);
  if (!content) return {};
  const Expected<std::vector<CmakeCommand>> commands = parse_cmake(*content, file);
  if (!commands) return {};
  for (const CmakeCommand& command : *commands)
    if (command.name == "set" && command.arguments.size() == 2 &&
        command.arguments[0].text == package + "_MSG_INCLUDE_DIRS")
      return split_list(command.arguments[1].text);
  return {};
}

std::vector<fs::path> message_folders(const fs::path& share, const std::string& package) {
  std::vector<fs::path> folders = devel_message_folders(share, package);
  if (folders.empty()) folders.push_back(share / package / "msg");
  const auto is_missing = [](const fs::path& folder) {
    std::error_code none;
    return !fs::is_directory(folder, none);
  };
  folders.erase(std::remove_if(folders.begin(), folders.end(), is_missing), folders.end());
  return folders;
}

/// The message folders of packages, by name.
using MessageFolders = std::map<std::string, std::vector<fs::path>>;

void add_package(const fs::path& share, const std::string& package, MessageFolders& all) {
  if (all.count(package) != 0) return;
  if (std::vector<fs::path> folders = message_folders(share, package); !folders.empty())
    all.emplace(package, std::move(folders));
}

/// The packages that CMake has found: PKG_DIR is share/PKG/cmake. Then all that lie beside them.
void add_found(const std::string& build_dir, MessageFolders& all) {
  const CmakeCache cache = CmakeCache::nearest(build_dir);
  std::set<fs::path> shares;
  for (const CacheEntry& entry : cache.entries()) {
    const fs::path package = fs::path(entry.value).parent_path();
    if (fs::path(entry.value).filename() != "cmake" || entry.name != package.filename().string() + "_DIR")
      continue;
    add_package(package.parent_path(), package.filename(), all);
    shares.insert(package.parent_path());
  }
  const std::vector<std::string> others = share_folders(build_dir);
  std::vector<fs::path> ordered(shares.begin(), shares.end());
  ordered.insert(ordered.end(), others.begin(), others.end());
  for (const fs::path& share : ordered) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(share, none))
      add_package(share, entry.path().filename(), all);
  }
}

/// -I PKG:DIR for the workspace's packages and for those of other workspaces and of the system that these do not hide.
std::vector<std::string> include_flags(const std::map<std::string, fs::path>& workspace,
                                       const std::set<std::string>& build_dirs) {
  MessageFolders all;
  for (const auto& [name, folder] : workspace) all[name] = {folder / "msg"};
  for (const std::string& build_dir : build_dirs) add_found(build_dir, all);
  std::vector<std::string> flags;
  for (const auto& [name, folders] : all)
    for (const fs::path& folder : folders)
      if (fs::exists(folder)) flags.insert(flags.end(), {"-I", name + ":" + folder.string()});
  return flags;
}

/// Where definitions of one package become headers.
struct Generation {
  std::string package;
  std::vector<std::string> flags;
  std::string output;
};

ProcessResult generate_these(const Generation& where, const std::vector<std::string>& files) {
  std::vector<std::string> command = {generator(), "generate", "-p", where.package, "-o", where.output};
  command.insert(command.end(), where.flags.begin(), where.flags.end());
  command.insert(command.end(), files.begin(), files.end());
  return run_process(command);
}

Expected<void> generate_all(const Generation& where, const fs::path& folder) {
  const ProcessResult result = generate_these(where, definitions(folder));
  if (result.status == 0) return {};
  return Error{
      "tzc-msggen could not generate the headers of its messages\n" + result.errors, folder,
      result.status < 0 ? "install tzc-msggen beside tzc-rewrite" : "repair the message definitions"};
}

/// One by one: a definition that is broken, or whose parts are nowhere, costs no other one its header.
void generate_what_can_be(const Generation& where, const fs::path& folder) {
  for (const std::string& file : definitions(folder)) generate_these(where, {file});
}

}  // namespace

MessageSources message_sources(const std::string& package_dir, const std::string& build_dir) {
  MessageSources sources;
  const std::map<std::string, fs::path> workspace = message_packages(package_dir);
  if (workspace.empty()) return sources;
  sources.generator = program_path(generator());
  for (const auto& [name, folder] : workspace)
    for (const char* kind : {"msg", "srv", "action"}) sources.folders.push_back(folder / kind);
  const std::vector<std::string> flags = include_flags(workspace, {build_dir});
  for (std::size_t i = 1; i < flags.size(); i += 2)
    sources.folders.push_back(flags[i].substr(flags[i].find(':') + 1));
  return sources;
}

Expected<OwnMessages> OwnMessages::generate(const std::map<std::string, std::string>& build_dirs) {
  OwnMessages messages;
  std::map<std::string, fs::path> all;
  for (const auto& item : build_dirs) all.merge(message_packages(item.first));
  if (all.empty()) return messages;
  Expected<ScratchFolder> scratch = ScratchFolder::make();
  if (!scratch) return scratch.error();
  messages.folder_.emplace(std::move(*scratch));
  std::set<std::string> folders;
  for (const auto& item : build_dirs) folders.insert(item.second);
  const std::vector<std::string> flags = include_flags(all, folders);
  for (const auto& [name, folder] : all) {
    messages.packages_[name] = folder;
    const Generation where{name, flags, messages.folder_->path()};
    const Expected<void> done = generate_all(where, folder);
    if (!done && build_dirs.count(folder) != 0) return done.error();
    if (!done) generate_what_can_be(where, folder);
  }
  return messages;
}

std::vector<std::string> OwnMessages::include_dirs() const {
  return folder_ ? std::vector<std::string>{folder_->path()} : std::vector<std::string>();
}

}  // namespace tzc::rewriter

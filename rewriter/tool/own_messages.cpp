// SPDX-License-Identifier: BSD-3-Clause
#include "tool/own_messages.h"

#include <signal.h>
#include <stdlib.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <map>

#include "buildfiles/package_xml.h"
#include "tool/places.h"
#include "tool/process.h"

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

/// The folder that holds the workspace's packages: the highest one above the package that a catkin workspace
/// marks, else the package's parent.
fs::path source_space(const fs::path& package) {
  for (fs::path folder = package.parent_path(); folder.has_relative_path(); folder = folder.parent_path())
    if (folder.filename() == "src" || fs::exists(folder.parent_path() / ".catkin_workspace")) return folder;
  return package.parent_path();
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

/// -I PKG:DIR for the workspace's packages and for installed ones that these do not hide.
std::vector<std::string> include_flags(const std::map<std::string, fs::path>& workspace,
                                       const std::string& build_dir) {
  std::map<std::string, fs::path> all;
  for (const auto& [name, folder] : workspace) all[name] = folder / "msg";
  for (const std::string& share : share_folders(build_dir)) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(share, none))
      if (fs::is_directory(entry.path() / "msg", none))
        all.emplace(entry.path().filename(), entry.path() / "msg");
  }
  std::vector<std::string> flags;
  for (const auto& [name, folder] : all)
    if (fs::exists(folder)) flags.insert(flags.end(), {"-I", name + ":" + folder.string()});
  return flags;
}

Expected<void> generate_one(const std::string& package, const fs::path& folder,
                            const std::vector<std::string>& flags, const std::string& output) {
  std::vector<std::string> command = {generator(), "generate", "-p", package, "-o", output};
  command.insert(command.end(), flags.begin(), flags.end());
  for (const std::string& file : definitions(folder)) command.push_back(file);
  const ProcessResult result = run_process(command);
  if (result.status == 0) return {};
  return Error{
      "tzc-msggen could not generate the headers of its messages\n" + result.errors, folder,
      result.status < 0 ? "install tzc-msggen beside tzc-rewrite" : "repair the message definitions"};
}

constexpr const char* folder_prefix = "tzc-rewrite-";

/// Folders that killed runs left behind: their names say which process they belonged to.
void remove_left_folders() {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(fs::temp_directory_path(), ignored)) {
    const std::string name = entry.path().filename();
    if (name.rfind(folder_prefix, 0) != 0) continue;
    const int process = std::atoi(name.c_str() + std::string(folder_prefix).size());
    if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) fs::remove_all(entry.path(), ignored);
  }
}

std::string make_folder() {
  remove_left_folders();
  std::string pattern = fs::temp_directory_path() / (folder_prefix + std::to_string(::getpid()) + "-XXXXXX");
  return ::mkdtemp(pattern.data()) ? pattern : "";
}

}  // namespace

Expected<OwnMessages> OwnMessages::generate(const std::string& package_dir, const std::string& build_dir) {
  OwnMessages messages;
  const std::map<std::string, fs::path> all = message_packages(package_dir);
  if (all.empty()) return messages;
  messages.folder_ = make_folder();
  if (messages.folder_.empty())
    return Error{std::string("no folder can be made: ") + std::strerror(errno), fs::temp_directory_path(),
                 ""};
  const std::vector<std::string> flags = include_flags(all, build_dir);
  for (const auto& [name, folder] : all) {
    messages.packages_[name] = folder;
    const Expected<void> done = generate_one(name, folder, flags, messages.folder_);
    // Another package's broken messages are its own business: what needs them will not compile and say so.
    if (!done && folder == package_dir) return done.error();
  }
  return messages;
}

OwnMessages::~OwnMessages() {
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
}

std::vector<std::string> OwnMessages::include_dirs() const {
  return folder_.empty() ? std::vector<std::string>() : std::vector<std::string>{folder_};
}

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#include "tool/own_messages.h"

#include <filesystem>
#include <map>
#include <set>

#include "buildfiles/package_xml.h"
#include "proof/compiler_reads.h"
#include "proof/process.h"
#include "tool/message_folders.h"
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

/// -I PKG:DIR
std::vector<std::string> include_flags(const MessageFolders& all) {
  std::vector<std::string> flags;
  for (const auto& [name, folders] : all)
    for (const fs::path& folder : folders) flags.insert(flags.end(), {"-I", name + ":" + folder.string()});
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
  const std::vector<std::string> flags = include_flags(message_folders(workspace, {build_dir}));
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
  const std::vector<std::string> flags = include_flags(message_folders(all, folders));
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

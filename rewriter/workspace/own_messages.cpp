// SPDX-License-Identifier: BSD-3-Clause
#include "workspace/own_messages.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "buildfiles/find_packages.h"
#include "buildfiles/package_xml.h"
#include "edits/files.h"
#include "proof/compiler_reads.h"
#include "proof/process.h"
#include "workspace/genmsg_files.h"
#include "workspace/message_folders.h"
#include "workspace/places.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// A message package of the workspace.
struct MessagePackage {
  fs::path folder;
  std::set<std::string> definitions;  ///< files
};
using MessagePackages = std::map<std::string, MessagePackage>;

/// Where genmsg has not said what it builds.
std::set<std::string> files_below(const fs::path& package) {
  std::set<std::string> files;
  for (const char* kind : {"msg", "srv", "action"}) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(package / kind, none))
      if (entry.path().extension() == std::string(".") + kind) files.insert(entry.path());
  }
  return files;
}

std::set<std::string> definitions(const PackageXml& package, const fs::path& folder,
                                  const std::set<fs::path>& shares) {
  for (const fs::path& share : shares)
    if (std::set<std::string> files = genmsg_definitions(share, package.name); !files.empty()) return files;
  return files_below(folder);
}

/// By name, the package itself among them.
MessagePackages message_packages(const std::string& package_dir, const std::set<std::string>& build_dirs) {
  MessagePackages found;
  const std::set<fs::path> shares = devel_shares(build_dirs);
  Expected<std::vector<std::string>> all = find_packages_at(source_space(package_dir));
  if (!all) all = std::vector<std::string>{package_dir};
  for (const std::string& folder : *all) {
    const Expected<PackageXml> package = read_package_xml(folder);
    if (!package) continue;
    std::set<std::string> files = definitions(*package, folder, shares);
    if (!files.empty()) found[package->name] = {folder, std::move(files)};
  }
  return found;
}

std::map<std::string, std::string> folders_of(const MessagePackages& packages) {
  std::map<std::string, std::string> folders;
  for (const auto& [name, package] : packages) folders.emplace(name, package.folder);
  return folders;
}

std::string generator() {
  const fs::path beside = fs::path(own_folder()) / "tzc-msggen";
  return is_there(beside) ? beside.string() : "tzc-msggen";
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

ProcessResult generate_these(const Generation& where, const std::set<std::string>& files) {
  std::vector<std::string> command = {generator(), "generate", "-p", where.package, "-o", where.output};
  command.insert(command.end(), where.flags.begin(), where.flags.end());
  command.insert(command.end(), files.begin(), files.end());
  return run_process(command);
}

Expected<void> generate_all(const Generation& where, const MessagePackage& package) {
  const ProcessResult result = generate_these(where, package.definitions);
  if (result.status == 0) return {};
  return Error{
      "tzc-msggen could not generate the headers of its messages\n" + result.errors, package.folder,
      result.status < 0 ? "install tzc-msggen beside tzc-rewrite" : "repair the message definitions"};
}

/// Whether gencpp has made its header, so that the package builds with it, although TZC has none for it: a message that only Python uses may have
/// a field `delete`.
bool is_built(const std::string& package, const std::string& file, const std::set<std::string>& builds) {
  const std::string name = fs::path(file).stem();
  for (const fs::path& share : devel_shares(builds))
    for (const char* ending : {".h", "Action.h"})
      if (is_there(share.parent_path() / "include" / package / (name + ending))) return true;
  return false;
}

/// Whether it costs the package nothing that some of its definitions become no headers of TZC.
bool builds_without(const Generation& where, const MessagePackage& package,
                    const std::set<std::string>& builds) {
  return std::all_of(package.definitions.begin(), package.definitions.end(), [&](const std::string& file) {
    return generate_these(where, {file}).status == 0 || is_built(where.package, file, builds);
  });
}

/// One by one: a definition that is broken, or whose parts are nowhere, costs no other one its header.
void generate_what_can_be(const Generation& where, const MessagePackage& package) {
  for (const std::string& file : package.definitions) generate_these(where, {file});
}

}  // namespace

MessageSources message_sources(const std::string& package_dir, const std::string& build_dir) {
  MessageSources sources;
  const MessagePackages workspace = message_packages(package_dir, {build_dir});
  if (workspace.empty()) return sources;
  sources.generator = program_path(generator());
  for (const auto& [name, package] : workspace)
    for (const char* kind : {"msg", "srv", "action"}) sources.folders.insert(package.folder / kind);
  for (const auto& [name, package] : workspace)
    for (const std::string& file : package.definitions) sources.folders.insert(fs::path(file).parent_path());
  for (const fs::path& share : devel_shares({build_dir}))
    for (const auto& [name, package] : workspace) sources.folders.insert(share / name / "cmake");
  for (const auto& [name, folders] : message_folders(folders_of(workspace), {build_dir}))
    sources.folders.insert(folders.begin(), folders.end());
  return sources;
}

Expected<OwnMessages> OwnMessages::generate(const std::map<std::string, std::string>& build_dirs) {
  OwnMessages messages;
  std::set<std::string> builds;
  for (const auto& item : build_dirs) builds.insert(item.second);
  MessagePackages all;
  for (const auto& item : build_dirs) all.merge(message_packages(item.first, builds));
  if (all.empty()) return messages;
  Expected<ScratchFolder> scratch = ScratchFolder::make();
  if (!scratch) return scratch.error();
  messages.folder_.emplace(std::move(*scratch));
  messages.packages_ = folders_of(all);
  const std::vector<std::string> flags = include_flags(message_folders(messages.packages_, builds));
  for (const auto& [name, package] : all) {
    const Generation where{name, flags, messages.folder_->path()};
    const Expected<void> done = generate_all(where, package);
    if (done) continue;
    if (build_dirs.count(package.folder) != 0 && !builds_without(where, package, builds)) return done.error();
    generate_what_can_be(where, package);
  }
  return messages;
}

std::vector<std::string> OwnMessages::include_dirs() const {
  return folder_ ? std::vector<std::string>{folder_->path()} : std::vector<std::string>();
}

}  // namespace tzc::rewriter

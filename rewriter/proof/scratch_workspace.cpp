// SPDX-License-Identifier: BSD-3-Clause
#include "proof/scratch_workspace.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <utility>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

constexpr unsigned deepest = 8;                       // folders between the root and a package
constexpr std::uintmax_t largest_copy = 1024 * 1024;  // bytes; larger files are data, a link serves

/// The package's own compiler cannot read either what this user may not.
bool is_readable(const std::string& path) {
  std::error_code failed;
  return ::access(path.c_str(), fs::is_directory(path, failed) ? R_OK | X_OK : R_OK) == 0;
}

bool is_skipped(const std::string& name) {
  static const std::set<std::string> names = {".git", ".hg", ".svn", ".tzc-rewrite"};
  return names.count(name) != 0;
}

Error no_copy(const std::string& what, const std::string& path) {
  return {"cannot be copied into a scratch folder: " + what, path, ""};
}

Expected<void> write_unsynced(const std::string& path, const std::string& content) {
  std::ofstream file(path, std::ios::binary);
  file << content;
  file.close();
  if (!file) return no_copy("the file cannot be written", path);
  return {};
}

}  // namespace

ScratchWorkspace::ScratchWorkspace(const std::string& root, const std::vector<std::string>& packages,
                                   std::string folder, const std::vector<std::string>& omitted)
    : root_(root), folder_(std::move(folder)) {
  for (const std::string& package : packages) places_[package];
  for (const std::string& one : omitted) {
    omitted_.insert(canonical_path(one));
    to_scratch_.except(one);
    to_scratch_.except(canonical_path(one));
  }
  find_places(root_, 0);
  for (auto& [package, place] : places_) {
    if (place.scratch.empty()) {  // not below the root as the build names it: it gets a place of its own
      place.named = package;
      place.scratch = folder_ + "/" + fs::path(package).filename().string();
    }
    to_scratch_.add(place.named, place.scratch);
    to_scratch_.add(package, place.scratch);
    to_user_.add(place.scratch, package);
  }
}

/// Whether a package lies behind a symbolic link, and not the root itself, too.
bool ScratchWorkspace::is_link_to_package(const std::string& link) const {
  const std::string folder = canonical_path(link), root = canonical_path(root_);
  return folder != root && !is_below(root, folder) &&
         std::any_of(places_.begin(), places_.end(),
                     [&](const auto& item) { return item.first == folder || is_below(item.first, folder); });
}

/// A package may lie behind a symbolic link below the root.
void ScratchWorkspace::find_places(const std::string& folder, unsigned depth) {
  if (const auto found = places_.find(canonical_path(folder)); found != places_.end()) {
    if (found->second.scratch.empty())
      found->second = {folder, folder == root_ ? folder_ : folder_ + folder.substr(root_.size())};
    return;
  }
  if (depth == deepest || omitted_.count(folder) || is_there(folder + "/package.xml")) return;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (entry.is_directory(ignored) && !is_skipped(entry.path().filename()) &&
        (!entry.is_symlink(ignored) || is_link_to_package(entry.path())))
      find_places(entry.path(), depth + 1);
}

bool ScratchWorkspace::leads_to_package(const std::string& folder) const {
  return std::any_of(places_.begin(), places_.end(), [&](const auto& item) {
    return item.second.named == folder || is_below(item.second.named, folder);
  });
}

void ScratchWorkspace::link(const std::string& target, const std::string& at) const {
  std::error_code ignored;
  fs::create_symlink(target, at, ignored);
}

Expected<void> ScratchWorkspace::make() {
  std::error_code failed;
  fs::create_directories(folder_, failed);
  if (Expected<void> done = mirror(root_, folder_); !done) return done;
  for (const auto& [package, place] : places_)
    if (!is_there(place.scratch))
      if (Expected<void> done = copy(package, place.scratch); !done) return done;
  return {};
}

Expected<void> ScratchWorkspace::mirror(const std::string& from, const std::string& to) {
  if (places_.count(canonical_path(from))) return copy(canonical_path(from), to);
  std::error_code failed;
  fs::create_directories(to, failed);
  for (const auto& entry : fs::directory_iterator(from, failed)) {
    const std::string name = entry.path().filename();
    if (is_skipped(name) || omitted_.count(canonical_path(entry.path()))) continue;
    if (std::error_code ignored; !entry.is_directory(ignored) || !leads_to_package(entry.path()))
      link(entry.path(), to + "/" + name);
    else if (Expected<void> done = mirror(entry.path(), to + "/" + name); !done)
      return done;
  }
  if (failed) return no_copy(failed.message(), from);
  return {};
}

Expected<void> ScratchWorkspace::copy(const std::string& from, const std::string& to) {
  std::error_code failed;
  fs::create_directories(to, failed);
  if (failed) return no_copy(failed.message(), to);
  for (const auto& entry : fs::directory_iterator(from, failed)) {
    const std::string name = entry.path().filename();
    if (is_skipped(name) || omitted_.count(entry.path())) continue;
    if (Expected<void> done = copy_entry(entry.path(), to + "/" + name); !done) return done;
  }
  if (failed) return no_copy(failed.message(), from);
  return {};
}

Expected<void> ScratchWorkspace::copy_entry(const std::string& from, const std::string& to) {
  std::error_code failed;
  if (fs::is_symlink(from, failed)) {
    link(to_scratch_.in_word(canonical_path(from)), to);
  } else if (!is_readable(from)) {
    link(from, to);
  } else if (fs::is_directory(from, failed)) {
    return copy(from, to);
  } else if (!fs::is_regular_file(from, failed) || fs::file_size(from, failed) > largest_copy) {
    link(from, to);
  } else {
    const Expected<std::string> content = read_file(from);
    if (!content) return content.error();
    if (Expected<void> done = put(to, to_scratch_.in_includes(*content)); !done) return done;
    fs::permissions(to, fs::status(from, failed).permissions() | fs::perms::owner_write, failed);
  }
  return {};
}

Expected<void> ScratchWorkspace::put(const std::string& file, const std::string& content) const {
  std::error_code failed;
  const fs::perms mode = fs::status(file, failed).permissions();
  const bool existed = fs::exists(file, failed);
  fs::remove(file, failed);  // it may be a link to the user's
  fs::create_directories(fs::path(file).parent_path(), failed);
  if (Expected<void> done = write_unsynced(file, content); !done) return done;
  if (existed) fs::permissions(file, mode | fs::perms::owner_write, failed);
  return {};
}

Expected<void> ScratchWorkspace::write(const FileContents& contents) {
  std::set<std::string> stale;
  std::swap(stale, written_);
  for (const auto& [file, content] : contents) {
    stale.erase(file);
    written_.insert(file);
    if (Expected<void> done = put(to_scratch_.in_word(file), to_scratch_.in_includes(content)); !done)
      return done;
  }
  for (const std::string& file : stale) {
    const Expected<std::string> content = read_file(file);
    if (!content) return content.error();
    if (Expected<void> done = put(to_scratch_.in_word(file), to_scratch_.in_includes(*content)); !done)
      return done;
  }
  return {};
}

}  // namespace tzc::rewriter

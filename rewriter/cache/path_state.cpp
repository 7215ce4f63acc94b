// SPDX-License-Identifier: BSD-3-Clause
#include "cache/path_state.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

/// Without the copies that a stream makes: compilers and their libraries are read as well.
bool read_whole(const std::string& path, std::string& text) {
  const int file = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) return false;
  struct stat state{};
  bool good = ::fstat(file, &state) == 0 && S_ISREG(state.st_mode);
  if (good) text.resize(static_cast<std::size_t>(state.st_size));
  std::size_t done = 0;
  while (good && done < text.size()) {
    const ssize_t n = ::read(file, text.data() + done, text.size() - done);
    good = n > 0;
    if (good) done += static_cast<std::size_t>(n);
  }
  ::close(file);
  return good;
}

std::vector<fs::path> sorted_entries(const std::string& folder) {
  std::vector<fs::path> entries;
  std::error_code failed;
  for (fs::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed))
    entries.push_back(at->path());
  std::sort(entries.begin(), entries.end());
  return entries;
}

bool is_version_control(const std::string& name) {
  static const std::set<std::string> names = {".git", ".hg", ".svn", ".tzc-rewrite"};
  return names.count(name) != 0;
}

std::string nearest_folder(const std::string& path) {
  fs::path folder = fs::path(path).parent_path();
  std::error_code ignored;
  while (folder.has_relative_path() && !fs::exists(folder, ignored)) folder = folder.parent_path();
  return folder;
}

std::string number(long long value) {
  return std::to_string(value) + " ";
}

}  // namespace

std::string PathStates::of(const std::string& path, Access access) const {
  switch (access) {
    case Access::content:
      return content(path);
    case Access::names:
      return names(path, 1);
    case Access::names2:
      return names(path, 2);
    case Access::tree:
      return tree(path);
  }
  return "";
}

std::string PathStates::content(const std::string& path) const {
  struct stat state{};
  if (::stat(path.c_str(), &state) != 0) return "absent";
  const std::string real = canonical_path(path);
  if (S_ISDIR(state.st_mode)) return "folder " + real;
  if (!S_ISREG(state.st_mode)) return "special " + real;
  std::string text;
  return read_whole(path, text) ? digest_(text) + " " + real : "unreadable " + real;
}

std::string PathStates::names(const std::string& folder, int depth) const {
  std::string all;
  for (const fs::path& entry : sorted_entries(folder)) {
    all += entry.filename().string() + "\n";
    std::error_code ignored;
    if (depth > 1 && fs::is_directory(entry, ignored)) all += names(entry, depth - 1) + "\n";
  }
  return digest_(all);
}

std::string PathStates::tree_file(const std::string& file) const {
  struct stat state{};
  if (::stat(file.c_str(), &state) != 0) return "absent";
  if (static_cast<std::size_t>(state.st_size) <= largest_read)
    return std::to_string(state.st_mode & 07777) + " " + content(file);
  return number(state.st_size) + number(state.st_mtim.tv_sec) + number(state.st_mtim.tv_nsec) +
         number(state.st_ctim.tv_sec) + number(state.st_ctim.tv_nsec) +
         number(static_cast<long long>(state.st_ino));
}

/// A symbolic link counts by where it leads, and a file behind it by its content.
std::string PathStates::tree(const std::string& folder) const {
  std::string all;
  for (const fs::path& entry : sorted_entries(folder)) {
    const std::string name = entry.filename();
    if (is_version_control(name) || omitted_.count(entry) != 0) continue;
    std::error_code ignored;
    all += name + "\n";
    if (fs::is_symlink(entry, ignored)) all += fs::read_symlink(entry, ignored).string() + "\n";
    if (fs::is_regular_file(entry, ignored))
      all += tree_file(entry) + "\n";
    else if (fs::is_directory(entry, ignored) && !fs::is_symlink(entry, ignored))
      all += tree(entry) + "\n";
  }
  return digest_(all);
}

bool ChangesSince::is_changed(const std::string& path) const {
  struct stat state{};
  if (::stat(path.c_str(), &state) != 0) return false;
  const bool whole_seconds =
      state.st_ctim.tv_nsec == 0;  // such file systems round down, by up to two seconds
  const long long last = state.st_ctim.tv_sec + (whole_seconds ? 2 : 0);
  return last > moment_.tv_sec || (last == moment_.tv_sec && state.st_ctim.tv_nsec >= moment_.tv_nsec);
}

/// Compilers look for each header in many folders: most of what they ask for is in none of a few.
bool ChangesSince::concern_absent(const std::string& path) {
  const std::string folder = fs::path(path).parent_path();
  const auto known = without_.find(folder);
  if (known != without_.end()) return known->second;
  return without_[folder] = is_changed(nearest_folder(path));
}

bool ChangesSince::concern(const std::string& path, Access access) {
  struct stat state{};
  if (::stat(path.c_str(), &state) != 0) return concern_absent(path);
  const bool is_folder = S_ISDIR(state.st_mode);
  if (access == Access::content) return !is_folder && is_changed(path);
  if (is_changed(path)) return true;
  if (!is_folder || access == Access::names) return false;
  for (const fs::path& entry : sorted_entries(path))
    if (concern(entry, access == Access::names2 ? Access::names : access)) return true;
  return false;
}

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#include "tool/staging.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>

namespace tzc::msggen {
namespace fs = std::filesystem;

Staging::~Staging() {
  std::error_code ignored;
  for (const Staged& file : staged_) {
    fs::remove(file.temporary, ignored);
    fs::remove(file.former(), ignored);
  }
  for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder) fs::remove(*folder, ignored);
}

std::string Staging::stage(const fs::path& target, const std::string& text) {
  std::error_code ignored;
  if (fs::is_directory(fs::symlink_status(target, ignored)))
    return fmt::format("cannot write {}: a folder is in its place", target.string());
  if (std::string error = create_folders(target.parent_path()); !error.empty()) return error;
  const fs::path temporary = target.string() + fmt::format(".{}.tmp", ::getpid());
  staged_.push_back({temporary, target});
  errno = 0;
  std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
  out << text;
  out.close();
  return out ? "" : fmt::format("cannot write {}: {}", temporary.string(), std::strerror(errno));
}

std::string Staging::commit() {
  std::string error;
  for (Staged& file : staged_) {
    if (error = keep_former(file); !error.empty()) break;
  }
  for (Staged& file : staged_) {
    if (!error.empty()) break;
    error = move(file);
  }
  error.empty() ? created_.clear() : take_back();
  return error;
}

// A second name of what is there; where the file system has no such thing, a copy.
std::string Staging::keep_former(Staged& file) {
  std::error_code error;
  if (!fs::exists(fs::symlink_status(file.target, error))) return "";
  fs::create_hard_link(file.target, file.former(), error);
  if (error) fs::copy_file(file.target, file.former(), fs::copy_options::overwrite_existing, error);
  file.has_former = !error;
  return error ? fmt::format("cannot keep a copy of {}: {}", file.target.string(), error.message()) : "";
}

std::string Staging::move(Staged& file) {
  std::error_code error;
  fs::rename(file.temporary, file.target, error);
  file.moved = !error;
  return error ? fmt::format("cannot write {}: {}", file.target.string(), error.message()) : "";
}

void Staging::take_back() {
  for (auto file = staged_.rbegin(); file != staged_.rend(); ++file) {
    if (!file->moved) continue;
    std::error_code error;
    if (file->has_former) {
      fs::rename(file->former(), file->target, error);
    } else {
      fs::remove(file->target, error);
    }
    if (error) changed_.push_back(file->target.string());
  }
}

std::string Staging::create_folders(const fs::path& folder) {
  if (folder.empty() || !known_.insert(folder.string()).second) return "";
  std::error_code error;
  if (fs::is_directory(folder, error)) return "";
  if (std::string above = create_folders(folder.parent_path()); !above.empty()) return above;
  if (fs::create_directory(folder, error)) created_.push_back(folder);
  std::error_code ignored;
  if (fs::is_directory(folder, ignored)) return "";
  return fmt::format("cannot create {}: {}", folder.string(), error.message());
}

}  // namespace tzc::msggen

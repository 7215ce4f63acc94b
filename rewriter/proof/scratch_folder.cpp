// SPDX-License-Identifier: BSD-3-Clause
#include "proof/scratch_folder.h"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

constexpr time_t youngest_leftover = 60;  // seconds: a younger folder may not be locked yet

int lock_of(const std::string& folder, int flags) {
  const int file = ::open((folder + "/.lock").c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | flags, 0600);
  if (file >= 0 && ::flock(file, LOCK_EX | LOCK_NB) == 0) return file;
  if (file >= 0) ::close(file);
  return -1;
}

bool is_left(const fs::path& folder) {
  struct stat info{};
  return ::lstat(folder.c_str(), &info) == 0 && S_ISDIR(info.st_mode) && info.st_uid == ::getuid() &&
         ::time(nullptr) - info.st_mtime > youngest_leftover;
}

void remove_leftovers(const fs::path& parent, const std::string& prefix) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(parent, ignored)) {
    if (entry.path().filename().string().rfind(prefix, 0) != 0 || !is_left(entry.path())) continue;
    const int lock = lock_of(entry.path(), 0);
    if (lock < 0) continue;  // in use, or not one of ours
    fs::remove_all(entry.path(), ignored);
    ::close(lock);
  }
}

}  // namespace

Expected<ScratchFolder> ScratchFolder::make() {
  std::error_code failed;
  const fs::path temporary = fs::temp_directory_path(failed);
  const fs::path parent = failed ? fs::path() : fs::canonical(temporary, failed);
  if (!failed)
    if (Expected<ScratchFolder> folder = make_in(parent, "tzc-rewrite-")) return folder;
  return Error{"no temporary folder can be made", parent,
               "make room there, or name a folder that exists with TMPDIR"};
}

Expected<ScratchFolder> ScratchFolder::make_in(const std::string& parent, const std::string& prefix) {
  remove_leftovers(parent, prefix);
  // mkdtemp(3) puts a unique name where the six Xs are.
  std::string path = fs::path(parent) / (prefix + "XXXXXX");
  const int lock = ::mkdtemp(path.data()) ? lock_of(path, O_CREAT) : -1;
  if (lock < 0)
    return Error{std::string("cannot be written: ") + std::strerror(errno), parent, "name another folder"};
  return ScratchFolder(path, lock);
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  if (!path().empty()) fs::remove_all(path(), ignored);
  if (lock_ >= 0) ::close(lock_);
}

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#include "transaction/swap.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <set>
#include <thread>

#include "edits/files.h"
#include "interruption/interruption.h"
#include "transaction/journal.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;

void (*swap_observer)(const char* step) = nullptr;

namespace {

void observe(const char* step) {
  if (swap_observer) swap_observer(step);
}

std::string system_text() {
  return std::strerror(errno);
}

/// The staging folder, held against other runs for the life of the object.
class Lock {
 public:
  /// Waits a second: a run that was just killed may hold it until the system has cleaned up.
  static Expected<Lock> take(const std::string& folder) {
    constexpr int attempts = 50;
    for (int i = 0; i < attempts; ++i) {
      Lock lock(folder);
      if (lock.descriptor_ < 0) return lock.failure(folder);
      if (lock.is_held()) return lock;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return Error{"another tzc-rewrite is working on this package", fs::path(folder).parent_path(),
                 "wait until it has finished"};
  }
  Lock(Lock&& other) noexcept
      : path_(std::move(other.path_)),
        no_folder_(other.no_folder_),
        no_file_(other.no_file_),
        descriptor_(other.descriptor_) {
    other.descriptor_ = -1;
  }
  Lock& operator=(Lock&&) = delete;
  ~Lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  explicit Lock(const std::string& folder) : path_(folder + "/lock") {
    fs::create_directory(folder, no_folder_);
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
    if (descriptor_ < 0) no_file_ = std::error_code(errno, std::generic_category());
  }

  /// Where the folder cannot be made, that no file can be made in it says nothing.
  Error failure(const std::string& folder) const {
    const std::string where = no_folder_ ? fs::path(folder).parent_path().string() : folder;
    return {"cannot be written: " + (no_folder_ ? no_folder_ : no_file_).message(), where,
            "make the folder writable for this user, or name another one for a ported copy with --out-dir"};
  }

  /// Locked, and still the file of that name: the run that held it before may have removed it.
  bool is_held() const {
    struct stat mine{}, named{};
    return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor_, &mine) == 0 &&
           ::stat(path_.c_str(), &named) == 0 && mine.st_ino == named.st_ino;
  }

  std::string path_;
  std::error_code no_folder_, no_file_;
  int descriptor_ = -1;
};

/// Root writes for the file's owner, as in a container with the user's workspace. Others own what they write.
Expected<void> give_to_owner(const std::string& staged, const struct stat& owned, const std::string& target) {
  if (::geteuid() != 0 || ::chown(staged.c_str(), owned.st_uid, owned.st_gid) == 0) return {};
  return Error{"cannot stay its owner's: " + system_text(), target,
               "run tzc-rewrite as the owner of the files"};
}

Expected<void> stage_file(const std::string& staged, const std::string& target, const std::string& content) {
  struct stat target_state{};
  if (::stat(target.c_str(), &target_state) != 0)
    return Error{"cannot be read: " + system_text(), target, "run tzc-rewrite again"};
  if (Expected<void> written = write_file(staged, content); !written) return written;
  struct stat staged_state{};
  ::stat(staged.c_str(), &staged_state);
  if (staged_state.st_dev != target_state.st_dev)
    return Error{"is on another file system than " + fs::path(staged).parent_path().parent_path().string(),
                 target, "run tzc-rewrite where the file really is"};
  if (::access(fs::path(target).parent_path().c_str(), W_OK) != 0)
    return Error{"its folder cannot be written: " + system_text(), target,
                 "make the folder writable, or use --out-dir"};
  if (Expected<void> given = give_to_owner(staged, target_state, target); !given) return given;
  ::chmod(staged.c_str(), target_state.st_mode & 07777);
  return {};
}

Expected<void> stage(const std::string& folder, const PackageSwap& package, Journal& journal) {
  for (const auto& [target, content] : package.contents) {
    const std::string staged = folder + "/" + std::to_string(journal.size());
    if (Expected<void> done = stage_file(staged, target, content); !done) return done.error();
    const auto old_hash = package.before.find(target);
    if (old_hash == package.before.end())
      return Error{"was not there when the package was analysed", target, "run tzc-rewrite again"};
    journal.push_back({staged, target, old_hash->second, content_hash(content)});
  }
  return {};
}

/// The step of a swap that both the run itself and a recovery take. Targets must hold their old or their new
/// content.
Expected<std::vector<std::string>> finish(const Journal& journal) {
  std::vector<std::string> replaced;
  for (const JournalEntry& entry : journal) {
    if (::rename(entry.staged.c_str(), entry.target.c_str()) == 0)
      replaced.push_back(entry.target);
    else if (errno != ENOENT)
      return Error{"cannot be replaced: " + system_text(), entry.target,
                   "make it writable and start tzc-rewrite again"};
    sync_folder(fs::path(entry.target).parent_path());
    observe("swapped");
  }
  return replaced;
}

Expected<void> check_targets(const Journal& journal, const std::string& folder) {
  for (const JournalEntry& entry : journal) {
    const Expected<std::string> content = read_file(entry.target);
    const std::uint64_t hash = content ? content_hash(*content) : 0;
    if (hash == entry.new_hash || (hash == entry.old_hash && is_there(entry.staged))) continue;
    return Error{"changed after a run of tzc-rewrite was interrupted in the middle of replacing files",
                 entry.target, "restore the package's files from version control, then remove " + folder};
  }
  return {};
}

bool is_staged_file(const std::string& name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

/// Removes what runs make in it, and the folder when nothing else is there: what is not ours stays.
void remove_folder(const std::string& folder) {
  std::error_code ignored;
  fs::remove(journal_path(folder), ignored);
  fs::remove(unfinished_journal_path(folder), ignored);
  std::vector<fs::path> staged;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (is_staged_file(entry.path().filename()) && !entry.is_directory(ignored))
      staged.push_back(entry.path());
  for (const fs::path& file : staged) fs::remove(file, ignored);
  fs::remove(folder + "/lock", ignored);
  fs::remove(folder, ignored);
}

std::string folder_of(const std::string& place) {
  return place + "/.tzc-rewrite";
}

std::vector<std::string> folders_of(const std::vector<PackageSwap>& packages) {
  std::vector<std::string> folders;
  for (const PackageSwap& package : packages) folders.push_back(package.package_dir);
  return folders;
}

/// The folders of a swap, held against other runs on any of its packages.
class Folders {
 public:
  static Expected<Folders> take(const std::vector<std::string>& packages) {
    Folders folders;
    std::set<std::string> places(packages.begin(), packages.end());
    places.insert(common_folder(packages));
    for (const std::string& place : places) {
      Expected<Lock> lock = Lock::take(folder_of(place));
      if (!lock) return folders.remove(), lock.error();
      folders.locks_.push_back(std::move(*lock));
      folders.taken_.push_back(folder_of(place));
    }
    return folders;
  }
  void remove() const {
    for (const std::string& folder : taken_) remove_folder(folder);
  }

 private:
  std::vector<Lock> locks_;
  std::vector<std::string> taken_;
};

Expected<Journal> stage(const std::string& folder, const std::vector<PackageSwap>& packages) {
  Journal journal;
  for (const PackageSwap& package : packages)
    if (Expected<void> done = stage(folder, package, journal); !done) return done.error();
  observe("staged");
  for (const PackageSwap& package : packages)
    if (Expected<void> same = check_unchanged(package.package_dir, package.before); !same)
      return same.error();
  return journal;
}

bool is_folder_of(const std::string& path, uid_t user) {
  struct stat state{};
  return ::lstat(path.c_str(), &state) == 0 && S_ISDIR(state.st_mode) && state.st_uid == user;
}

}  // namespace

Expected<void> swap_in(const std::vector<PackageSwap>& packages) {
  if (std::all_of(packages.begin(), packages.end(), [](auto& package) { return package.contents.empty(); }))
    return {};
  const std::string folder = folder_of(common_folder(folders_of(packages)));
  const Expected<Folders> folders = Folders::take(folders_of(packages));
  if (!folders) return folders.error();
  const Expected<Journal> journal = stage(folder, packages);
  if (!journal) return folders->remove(), journal.error();

  const InterruptionDelay until_swapped;
  if (Expected<void> written = write_journal(folder, *journal); !written) return folders->remove(), written;
  observe("journal");
  if (Expected<std::vector<std::string>> done = finish(*journal); !done) return done.error();
  folders->remove();
  return {};
}

bool is_swap_unfinished(const std::vector<std::string>& packages) {
  return is_there(journal_path(folder_of(common_folder(packages))));
}

std::vector<std::string> swap_folders(const std::vector<std::string>& packages, uid_t user) {
  std::set<std::string> above;
  for (const std::string& package : packages)
    for (fs::path place = fs::path(package).parent_path();; place = place.parent_path()) {
      if (is_folder_of(folder_of(place), user)) above.insert(place);
      if (!place.has_relative_path()) break;
    }
  std::vector<std::string> all(above.begin(), above.end());
  for (const std::string& package : packages)
    if (above.count(package) == 0) all.push_back(package);
  return all;
}

Expected<std::vector<std::string>> recover(const std::string& place) {
  const std::string folder = folder_of(place);
  std::vector<std::string> replaced;
  if (!is_there(folder)) return replaced;
  const Expected<Lock> lock = Lock::take(folder);
  if (!lock) return lock.error();
  if (is_there(journal_path(folder))) {
    const Expected<Journal> journal = read_journal(folder);
    if (!journal) return journal.error();
    if (Expected<void> fit = check_targets(*journal, folder); !fit) return fit.error();
    const InterruptionDelay until_swapped;
    Expected<std::vector<std::string>> done = finish(*journal);
    if (!done) return done;
    replaced = *done;
  }
  remove_folder(folder);
  return replaced;
}

}  // namespace tzc::rewriter

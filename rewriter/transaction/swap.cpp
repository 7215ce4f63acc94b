// SPDX-License-Identifier: BSD-3-Clause
#include "transaction/swap.h"

#include <fcntl.h>
#include <signal.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <filesystem>
#include <thread>

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
      if (lock.descriptor_ < 0) return Error{"cannot be written: " + system_text(), folder, ""};
      if (lock.is_held()) return lock;
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return Error{"another tzc-rewrite is working on this package", fs::path(folder).parent_path(),
                 "wait until it has finished"};
  }
  Lock(Lock&& other) noexcept : path_(std::move(other.path_)), descriptor_(other.descriptor_) {
    other.descriptor_ = -1;
  }
  Lock& operator=(Lock&&) = delete;
  ~Lock() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }

 private:
  explicit Lock(const std::string& folder) : path_(folder + "/lock") {
    std::error_code failed;
    fs::create_directory(folder, failed);
    descriptor_ = ::open(path_.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0644);
  }

  /// Locked, and still the file of that name: the run that held it before may have removed it.
  bool is_held() const {
    struct stat mine{}, named{};
    return ::flock(descriptor_, LOCK_EX | LOCK_NB) == 0 && ::fstat(descriptor_, &mine) == 0 &&
           ::stat(path_.c_str(), &named) == 0 && mine.st_ino == named.st_ino;
  }

  std::string path_;
  int descriptor_ = -1;
};

/// Delays Ctrl-C until the swap is over, which takes milliseconds.
class SignalsBlocked {
 public:
  SignalsBlocked() {
    sigset_t set;
    sigemptyset(&set);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&set, signal);
    pthread_sigmask(SIG_BLOCK, &set, &before_);
  }
  ~SignalsBlocked() { pthread_sigmask(SIG_SETMASK, &before_, nullptr); }
  SignalsBlocked(const SignalsBlocked&) = delete;
  SignalsBlocked& operator=(const SignalsBlocked&) = delete;

 private:
  sigset_t before_;
};

Expected<void> stage_file(const std::string& staged, const std::string& target, const std::string& content) {
  struct stat target_state{};
  if (::stat(target.c_str(), &target_state) != 0)
    return Error{"cannot be read: " + system_text(), target, ""};
  if (Expected<void> written = write_file(staged, content); !written) return written;
  struct stat staged_state{};
  ::stat(staged.c_str(), &staged_state);
  if (staged_state.st_dev != target_state.st_dev)
    return Error{"is on another file system than its package", target,
                 "run tzc-rewrite where the file really is"};
  if (::access(fs::path(target).parent_path().c_str(), W_OK) != 0)
    return Error{"its folder cannot be written: " + system_text(), target, ""};
  ::chmod(staged.c_str(), target_state.st_mode & 07777);
  return {};
}

Expected<Journal> stage(const std::string& folder, const FileContents& contents, const Snapshot& before) {
  Journal journal;
  for (const auto& [target, content] : contents) {
    const std::string staged = folder + "/" + std::to_string(journal.size());
    if (Expected<void> done = stage_file(staged, target, content); !done) return done.error();
    const auto old_hash = before.find(target);
    if (old_hash == before.end()) return Error{"was not there when the package was analysed", target, ""};
    journal.push_back({staged, target, old_hash->second, content_hash(content)});
  }
  return journal;
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
    if (hash == entry.new_hash || (hash == entry.old_hash && fs::exists(entry.staged))) continue;
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

std::string folder_of(const std::string& package_dir) {
  return package_dir + "/.tzc-rewrite";
}

}  // namespace

Expected<void> swap_in(const std::string& package_dir, const FileContents& contents, const Snapshot& before) {
  if (contents.empty()) return {};
  const std::string folder = folder_of(package_dir);
  const Expected<Lock> lock = Lock::take(folder);
  if (!lock) return lock.error();
  const Expected<Journal> journal = stage(folder, contents, before);
  if (!journal) return remove_folder(folder), journal.error();
  observe("staged");
  if (Expected<void> same = check_unchanged(package_dir, before); !same) return remove_folder(folder), same;

  const SignalsBlocked blocked;
  if (Expected<void> written = write_journal(folder, *journal); !written)
    return remove_folder(folder), written;
  observe("journal");
  if (Expected<std::vector<std::string>> done = finish(*journal); !done) return done.error();
  remove_folder(folder);
  return {};
}

bool is_swap_unfinished(const std::string& package_dir) {
  return fs::exists(journal_path(folder_of(package_dir)));
}

Expected<std::vector<std::string>> recover(const std::string& package_dir) {
  const std::string folder = folder_of(package_dir);
  std::vector<std::string> replaced;
  if (!fs::exists(folder)) return replaced;
  const Expected<Lock> lock = Lock::take(folder);
  if (!lock) return lock.error();
  if (fs::exists(journal_path(folder))) {
    const Expected<Journal> journal = read_journal(folder);
    if (!journal) return journal.error();
    if (Expected<void> fit = check_targets(*journal, folder); !fit) return fit.error();
    const SignalsBlocked blocked;
    Expected<std::vector<std::string>> done = finish(*journal);
    if (!done) return done;
    replaced = *done;
  }
  remove_folder(folder);
  return replaced;
}

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#include "cache/result_store.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <vector>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

constexpr const char* ending = ".port";
constexpr const char* former_ending = ".result";  // such entries began with the user's environment
constexpr const char* unfinished = ".part";
constexpr std::chrono::hours oldest_unfinished{1};

// digest of what follows \n length of the key \n key result
std::string packed(const std::string& key, const std::string& result) {
  return std::to_string(key.size()) + "\n" + key + result;
}

std::optional<std::string> unpacked(const std::string& text, const std::string& key) {
  const std::string head = packed(key, "");
  if (text.compare(0, head.size(), head) != 0) return {};
  return text.substr(head.size());
}

struct Entry {
  fs::path path;
  std::uintmax_t size = 0;
  fs::file_time_type used;
};

/// By a run that was killed, or by an earlier tzc-rewrite.
bool is_left(const Entry& entry) {
  const bool is_old = entry.used + oldest_unfinished < fs::file_time_type::clock::now();
  return entry.path.extension() == former_ending || (entry.path.extension() == unfinished && is_old);
}

}  // namespace

std::string ResultStore::entry_of(const std::string& key) const {
  return folder_ + "/" + digest_(key) + ending;
}

std::optional<std::string> ResultStore::find(const std::string& key) const {
  if (folder_.empty()) return {};
  const std::string path = entry_of(key);
  const Expected<std::string> text = read_file(path);
  if (!text) return {};
  const std::size_t end = text->find('\n');
  if (end == std::string::npos) return {};
  const std::string body = text->substr(end + 1);
  if (digest_(body) != text->substr(0, end)) return {};
  std::error_code ignored;
  fs::last_write_time(path, fs::file_time_type::clock::now(), ignored);
  return unpacked(body, key);
}

void ResultStore::keep(const std::string& key, const std::string& result) const {
  if (folder_.empty() || result.size() > most_bytes_) return;
  std::error_code failed;
  fs::create_directories(folder_, failed);
  const std::string path = entry_of(key), staged = path + "-" + std::to_string(::getpid()) + unfinished;
  const std::string body = packed(key, result);
  const bool written = static_cast<bool>(write_file(staged, digest_(body) + "\n" + body, 0600));
  if (written) fs::rename(staged, path, failed);
  if (!written || failed) fs::remove(staged, failed);
  shrink();
}

void ResultStore::shrink() const {
  std::vector<Entry> entries;
  std::error_code gone;  // another run may remove what this one looks at
  std::uintmax_t total = 0;
  for (fs::directory_iterator at(folder_, gone), end; !gone && at != end; at.increment(gone)) {
    std::error_code vanished;
    const Entry entry{at->path(), at->file_size(vanished), at->last_write_time(vanished)};
    if (vanished) continue;
    if (entry.path.extension() == ending) {
      total += entry.size;
      entries.push_back(entry);
    } else if (is_left(entry)) {
      fs::remove(entry.path, vanished);
    }
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) { return a.used < b.used; });
  for (const Entry& entry : entries) {
    if (total <= most_bytes_) return;
    fs::remove(entry.path, gone);
    total -= entry.size;
  }
}

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#include "edits/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

Error system_error(const std::string& what, const std::string& path) {
  return {what + ": " + std::strerror(errno), path, ""};
}

bool write_all(int descriptor, std::string_view content) {
  while (!content.empty()) {
    const ssize_t n = ::write(descriptor, content.data(), content.size());
    if (n < 0 && errno != EINTR) return false;
    if (n > 0) content.remove_prefix(static_cast<std::size_t>(n));
  }
  return true;
}

bool has_usual_name(const fs::path& path) {
  static const std::set<std::string> extensions = {".c", ".msg", ".srv", ".action", ".cmake"};
  const std::string name = path.filename().string();
  return extensions.count(path.extension().string()) || name == "CMakeLists.txt" || name == "package.xml" ||
         is_cpp_source(path) || is_cpp_header(path);
}

template <class IsOut>
void leave_out(Snapshot& files, IsOut is_out) {
  for (auto at = files.begin(); at != files.end();) at = is_out(at->first) ? files.erase(at) : std::next(at);
}

bool is_hidden(const fs::path& path) {
  return path.filename().string().front() == '.';
}

}  // namespace

bool is_cpp_source(const std::string& path) {
  static const std::set<std::string> extensions = {".cpp", ".CPP", ".cc", ".cxx", ".c++", ".C", ".cp"};
  return extensions.count(fs::path(path).extension()) != 0;
}

bool is_cuda_source(const std::string& path) {
  return fs::path(path).extension() == ".cu";
}

bool is_cpp_header(const std::string& path) {
  static const std::set<std::string> extensions = {".cuh", ".h",   ".hh",  ".hpp", ".hxx", ".h++", ".H",
                                                   ".icc", ".inc", ".inl", ".ipp", ".tcc", ".tpp", ".txx"};
  return extensions.count(fs::path(path).extension()) != 0;
}

bool is_there(const std::string& path) {
  std::error_code unreadable;
  return fs::exists(path, unreadable);
}

Expected<std::string> read_file(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) return system_error("cannot be read", path);
  std::ostringstream content;
  content << file.rdbuf();
  return content.str();
}

Expected<void> write_file(const std::string& path, std::string_view content, unsigned mode) {
  const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, mode);
  if (descriptor < 0) return system_error("cannot be written", path);
  const bool written = write_all(descriptor, content) && ::fsync(descriptor) == 0;
  const Error error = system_error("cannot be written", path);
  ::close(descriptor);
  if (!written) return error;
  return {};
}

void sync_folder(const std::string& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

bool is_text_file(const std::string& path) {
  constexpr std::uintmax_t largest = 4 << 20;
  std::error_code failed;
  const std::uintmax_t size = fs::file_size(path, failed);
  if (failed || size > largest) return false;
  char begin[512];
  std::ifstream stream(path, std::ios::binary);
  stream.read(begin, sizeof begin);
  return std::find(begin, begin + stream.gcount(), '\0') == begin + stream.gcount();
}

std::uint64_t content_hash(std::string_view content) {
  std::uint64_t hash = 14695981039346656037u;
  for (const char c : content) hash = (hash ^ static_cast<unsigned char>(c)) * 1099511628211u;
  return hash;
}

Snapshot snapshot(const std::string& package_dir) {
  Snapshot files;
  std::error_code ignored;
  const auto options = fs::directory_options::skip_permission_denied;
  for (auto at = fs::recursive_directory_iterator(package_dir, options, ignored), end = decltype(at){};
       at != end; at.increment(ignored)) {
    if (is_hidden(at->path())) {
      at.disable_recursion_pending();
      continue;
    }
    if (!at->is_regular_file(ignored)) continue;
    if (!has_usual_name(at->path()) && !is_text_file(at->path())) continue;
    const Expected<std::string> content = read_file(at->path());
    if (!content) continue;
    files[at->path()] = content_hash(*content);
    if (!at->is_symlink(ignored)) continue;
    const std::string real = canonical_path(at->path());  // of CMakeLists.txt -> CMakeLists_ros1.txt, say
    if (is_below(real, package_dir)) files[real] = content_hash(*content);
  }
  return files;
}

Snapshot of_read_files(Snapshot all, const std::set<std::string>& read) {
  leave_out(all, [&](const std::string& file) { return !has_usual_name(file) && read.count(file) == 0; });
  return all;
}

Expected<void> check_unchanged(const std::string& package_dir, const Snapshot& since) {
  Snapshot now = snapshot(package_dir);
  leave_out(now, [&](const std::string& file) { return !has_usual_name(file) && since.count(file) == 0; });
  auto differs_in = [](const Snapshot& all, const Snapshot& other) -> const std::string* {
    for (const auto& [path, hash] : all) {
      const auto found = other.find(path);
      if (found == other.end() || found->second != hash) return &path;
    }
    return nullptr;
  };
  const std::string* changed = differs_in(since, now);
  if (!changed) changed = differs_in(now, since);
  if (!changed) return {};
  return Error{"changed while the package was being analysed; nothing was written", *changed,
               "run tzc-rewrite again"};
}

std::string common_folder(const std::vector<std::string>& folders) {
  fs::path common = folders.front();
  for (const std::string& folder : folders)
    while (common.string() != folder && !is_below(folder, common)) common = common.parent_path();
  return common;
}

std::string canonical_path(const std::string& path) {
  std::error_code failed;
  const fs::path found = fs::canonical(path, failed);
  return failed ? fs::path(path).lexically_normal().string() : found.string();
}

}  // namespace tzc::rewriter

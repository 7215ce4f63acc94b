// SPDX-License-Identifier: BSD-3-Clause
#include "tool/output.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

bool has_content(const fs::path& file, const std::string& text) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::ifstream in(file, std::ios::binary);
  return in.is_open() && std::string(std::istreambuf_iterator<char>(in), {}) == text;
}

// The files of one run on their way; what was not moved into place is removed, and so are folders made for
// it.
class Staging {
 public:
  ~Staging() {
    std::error_code ignored;
    for (const Staged& file : staged_) fs::remove(file.temporary, ignored);
    for (auto folder = created_.rbegin(); folder != created_.rend(); ++folder) fs::remove(*folder, ignored);
  }

  // Empty, or what went wrong.
  std::string stage(const fs::path& target, const std::string& text) {
    if (std::string error = create_folders(target.parent_path()); !error.empty()) return error;
    const fs::path temporary = target.string() + fmt::format(".{}.tmp", ::getpid());
    staged_.push_back({temporary, target});
    errno = 0;
    std::ofstream out(temporary, std::ios::binary | std::ios::trunc);
    out << text;
    out.close();
    return out ? "" : fmt::format("cannot write {}: {}", temporary.string(), std::strerror(errno));
  }

  std::string commit() {
    std::error_code error;
    for (const Staged& file : staged_) {
      fs::rename(file.temporary, file.target, error);
      if (error) return fmt::format("cannot write {}: {}", file.target.string(), error.message());
    }
    created_.clear();
    return "";
  }

 private:
  struct Staged {
    fs::path temporary, target;
  };

  std::string create_folders(const fs::path& folder) {
    if (folder.empty() || !known_.insert(folder.string()).second) return "";
    std::error_code error;
    if (fs::is_directory(folder, error)) return "";
    if (std::string above = create_folders(folder.parent_path()); !above.empty()) return above;
    if (fs::create_directory(folder, error)) created_.push_back(folder);
    std::error_code ignored;
    if (fs::is_directory(folder, ignored)) return "";
    return fmt::format("cannot create {}: {}", folder.string(), error.message());
  }

  std::vector<Staged> staged_;
  std::vector<fs::path> created_;
  std::set<std::string> known_;
};

// Ctrl-C and its like wait until all files are in place, or gone.
class SignalsWait {
 public:
  SignalsWait() {
    sigset_t signals;
    ::sigemptyset(&signals);
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT}) ::sigaddset(&signals, signal);
    ::sigprocmask(SIG_BLOCK, &signals, &before_);
  }
  ~SignalsWait() { ::sigprocmask(SIG_SETMASK, &before_, nullptr); }
  SignalsWait(const SignalsWait&) = delete;
  SignalsWait& operator=(const SignalsWait&) = delete;

 private:
  sigset_t before_;
};

}  // namespace

std::size_t write_headers(const std::vector<Header>& headers, const OutputOptions& options,
                          Diagnostics& diagnostics) {
  const SignalsWait signals_wait;
  Staging staging;
  std::size_t replaced = 0;
  std::string error;
  for (const Header& header : headers) {
    const fs::path target = fs::path(options.folder) / header.path;
    if (options.if_changed && has_content(target, header.text)) continue;
    error = staging.stage(target, header.text);
    if (!error.empty()) break;
    ++replaced;
  }
  if (error.empty()) error = staging.commit();
  if (error.empty()) return replaced;
  Diagnostic d;
  d.message = error;
  d.hint = "nothing was generated; is the folder of -o writable, and is there space?";
  diagnostics.report(std::move(d));
  return 0;
}

}  // namespace tzc::msggen

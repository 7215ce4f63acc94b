// SPDX-License-Identifier: BSD-3-Clause
#include "tool/output.h"

#include <fmt/format.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "tool/staging.h"

namespace tzc::msggen {
namespace {

namespace fs = std::filesystem;

bool has_content(const fs::path& file, const std::string& text) {
  std::error_code ignored;
  if (!fs::is_regular_file(file, ignored)) return false;
  std::ifstream in(file, std::ios::binary);
  return in.is_open() && std::string(std::istreambuf_iterator<char>(in), {}) == text;
}

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

std::string hint(const Staging& staging) {
  if (staging.changed().empty())
    return "nothing was generated; is the folder of -o writable, and is there space?";
  return fmt::format("generate again; files that could not be put back: {}",
                     fmt::join(staging.changed(), ", "));
}

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
  d.hint = hint(staging);
  diagnostics.report(std::move(d));
  return 0;
}

}  // namespace tzc::msggen

// SPDX-License-Identifier: BSD-3-Clause
#include "tool/report_files.h"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include "edits/files.h"

namespace tzc::rewriter {
namespace fs = std::filesystem;
namespace {

std::string text_of(const std::string& file, const RunReport& run, const RunInfo& info) {
  const std::string extension = fs::path(file).extension();
  return extension == ".json"    ? to_json(run)
         : extension == ".sarif" ? to_sarif(run, info.version)
                                 : to_html(run, info);
}

/// A device or a pipe is written as it is.
bool is_special(const std::string& file) {
  std::error_code failed;
  return fs::exists(file, failed) && !fs::is_regular_file(file, failed);
}

/// Known without writing to it: what is written to a pipe is read at once.
Expected<void> check_special(const std::string& file) {
  std::error_code failed;
  if (fs::is_directory(file, failed))
    return Error{"is a folder", file, "name the file in it that the report goes into"};
  if (::access(file.c_str(), W_OK) != 0) return Error{"cannot be written", file, "name another file"};
  return {};
}

}  // namespace

Expected<void> ReportFiles::add(const std::string& file) {
  const std::string target = fs::weakly_canonical(file);  // a link stays a link
  if (std::any_of(files_.begin(), files_.end(), [&](const File& other) { return other.target == target; }))
    return Error{"is named twice", file, "name another file for the second report"};
  const bool special = is_special(file);
  const std::string staged = special ? target : target + ".tzc-rewrite-" + std::to_string(::getpid());
  if (Expected<void> fit = special ? check_special(file) : write_file(staged, ""); !fit)
    return special ? fit : Error{fit.error().what, file, "name a folder that exists and can be written"};
  files_.push_back({target, staged});
  return {};
}

Expected<ReportFiles> ReportFiles::open(const std::vector<std::string>& files) {
  ReportFiles reports;
  for (const std::string& file : files)
    if (Expected<void> added = reports.add(file); !added) return added.error();
  return reports;
}

ReportFiles::~ReportFiles() {
  std::error_code ignored;
  for (const File& file : files_)
    if (file.staged != file.target) fs::remove(file.staged, ignored);
}

Expected<void> ReportFiles::write(const RunReport& run, const RunInfo& info) {
  while (!files_.empty()) {
    const File file = files_.back();
    if (Expected<void> done = write_file(file.staged, text_of(file.target, run, info)); !done) return done;
    std::error_code failed;
    if (file.staged != file.target) fs::rename(file.staged, file.target, failed);
    if (failed)
      return Error{"cannot be written: " + failed.message(), file.target, "name another file after --report"};
    files_.pop_back();
  }
  return {};
}

}  // namespace tzc::rewriter

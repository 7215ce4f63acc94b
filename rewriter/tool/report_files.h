// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "model/expected.h"
#include "report/output.h"

namespace tzc::rewriter {

/// The files of --report. Each is opened beside its target before the analysis, so that a place that cannot
/// be written is known at once, and renamed into place when it is whole.
class ReportFiles {
 public:
  /// The endings are known to be .json, .sarif or .html.
  static Expected<ReportFiles> open(const std::vector<std::string>& files);

  ReportFiles(ReportFiles&& other) noexcept : files_(std::move(other.files_)) { other.files_.clear(); }
  ReportFiles& operator=(ReportFiles&&) = delete;
  ~ReportFiles();

  Expected<void> write(const RunReport& run, const RunInfo& info);

 private:
  struct File {
    std::string target, staged;
  };
  ReportFiles() = default;
  Expected<void> add(const std::string& file);
  std::vector<File> files_;  ///< not renamed yet
};

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <set>
#include <string>

#include "model/folder_set.h"

namespace tzc::rewriter {

/// Visits text files below folders, each once, through links as well. Build trees and hidden files are left out.
class TextFiles {
 public:
  using Visit = std::function<void(const std::string& path)>;
  using IsWanted = std::function<bool(const std::string& name)>;

  /// `without`: folders that are left out. `is_wanted`: asked for each file's name, before it is opened; empty: all are.
  explicit TextFiles(Visit visit, FolderSet without = {}, IsWanted is_wanted = {})
      : visit_(std::move(visit)), without_(std::move(without)), is_wanted_(std::move(is_wanted)) {}

  void walk(const std::string& folder);

 private:
  bool is_left_out(const std::string& folder) const;

  Visit visit_;
  FolderSet without_;
  IsWanted is_wanted_;
  std::set<std::string> seen_;
};

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <set>
#include <string>
#include <vector>

namespace tzc::msggen {

/// The files of one run on their way: each is written beside its place first, and all are moved there when all
/// are complete. If that fails half-way, those that were moved are taken back. Temporary files are removed in
/// the end, and folders that were made for nothing, too. Only killing the program leaves something in between.
class Staging {
 public:
  Staging() = default;
  ~Staging();
  Staging(const Staging&) = delete;
  Staging& operator=(const Staging&) = delete;

  /// Empty, or what went wrong.
  std::string stage(const std::filesystem::path& target, const std::string& text);
  /// Empty, or what went wrong; then all is as it was but for changed().
  std::string commit();
  /// Files that a failed commit() has moved into place and could not take back.
  const std::vector<std::string>& changed() const { return changed_; }

 private:
  struct Staged {
    std::filesystem::path temporary, target;
    std::filesystem::path former() const { return temporary.string() + ".old"; }
    bool moved = false, has_former = false;
  };

  std::string create_folders(const std::filesystem::path& folder);
  static std::string keep_former(Staged& file);
  static std::string move(Staged& file);
  void take_back();

  std::vector<Staged> staged_;
  std::vector<std::filesystem::path> created_;
  std::set<std::string> known_;
  std::vector<std::string> changed_;
};

}  // namespace tzc::msggen

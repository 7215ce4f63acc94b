// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "port/package_port.h"
#include "proof/scratch_folder.h"
#include "workspace/git.h"

namespace tzc::rewriter {

/// The diff of all packages. Its paths suit `git apply` from anywhere in the repository that holds both the
/// package and the working folder; otherwise `git apply` and `patch -p1` in the working folder, or in the
/// package's folder when that does not lie below the working folder.
std::string diff_of(const std::vector<PackagePort>& ports);

/// The files that the ports change and whose present content git cannot bring back. An error when git does not say.
Expected<OutsideGit> outside_git(const std::vector<PackagePort>& ports);

/// Packages that are all written, or none of them.
using WriteUnit = std::vector<const PackagePort*>;

/// The packages in these units, those first that come first.
std::vector<WriteUnit> write_units(const std::vector<PackagePort>& ports);

/// Changes packages in place, all of their files or none.
Expected<void> write_in_place(const WriteUnit& unit);

/// Whether that was interrupted when it could not be undone any more: the next run finishes it.
bool is_swap_unfinished(const WriteUnit& unit);

/// What a copy would write over: a file, or a folder in the place of one, that holds something else.
struct Overwritten {
  std::string path;     ///< without symbolic links above it
  FileChange change{};  ///< relative to the folder of --out-dir; of text alone
  bool is_text = false;
};

/// The folder of --out-dir: gets a whole copy of each package, ported. What is named is a package: as DIR/<its
/// folder>. It is a folder that holds packages: each at the path that it has below that folder. Each copy is made
/// beside its place and renamed into it when it is whole.
class OutDir {
 public:
  /// Makes the folder. An error when it cannot be written, or cannot hold copies of these packages.
  /// `named`: what the user named, which are the packages or hold them.
  static Expected<OutDir> open(const std::string& folder, const std::vector<std::string>& packages,
                               const std::vector<std::string>& named);

  OutDir(OutDir&& other) noexcept = default;
  OutDir& operator=(OutDir&&) = delete;
  ~OutDir();

  /// Makes the copy, beside its place.
  Expected<void> stage(const PackagePort& port) const;

  /// What is in the staged copy's place and differs from it.
  std::vector<Overwritten> overwritten_by(const PackagePort& port) const;

  const std::string& folder() const { return folder_; }

  /// Moves the staged copy into its place.
  Expected<void> move_in(const PackagePort& port) const;

 private:
  void compare(const std::filesystem::path& staged, const std::filesystem::path& to,
               std::vector<Overwritten>& found) const;
  explicit OutDir(std::string folder) : folder_(std::move(folder)) {}

  std::string folder_;                         ///< canonical
  std::optional<ScratchFolder> staging_;       ///< in it
  std::map<std::string, std::string> places_;  ///< package -> its path in the folder
  bool is_new_ = false;                        ///< made by this run: removed in the end when it is empty
};

}  // namespace tzc::rewriter

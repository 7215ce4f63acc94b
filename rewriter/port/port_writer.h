// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "port/undo.h"
#include "port/writing.h"

namespace tzc::rewriter {

/// Writes what a run ports, in place or into another folder, and keeps what takes it back.
class PortWriter {
 public:
  /// Opens the places, so that what cannot be written is known before the analysis.
  static Expected<PortWriter> open(const PortOptions& options, const std::vector<std::string>& packages);

  /// Writes packages one after the other, those that are joined at once. After an error `ports` holds those that were
  /// written.
  Expected<void> write(std::vector<PackagePort>& ports);

  /// A user's file may have changed: from then on no run ends as if nothing had happened.
  bool has_written() const { return has_written_; }

  /// The command that takes the port back; empty: there is none.
  std::string undo_command() const { return undo_ && !out_dir_ ? undo_->command() : ""; }

  /// What the user should know though the run succeeds.
  std::vector<std::string> warnings() const;

 private:
  explicit PortWriter(const PortOptions& options) : options_(options) {}
  Expected<void> look_at_git(const std::vector<PackagePort>& ports);
  Expected<void> stage(const std::vector<PackagePort>& ports);
  Expected<void> keep_overwritten(const std::vector<Overwritten>& files);
  Expected<void> write_unit(const WriteUnit& unit);
  Expected<void> save_undo(const WriteUnit& unit);
  void note_written(const PackagePort& port);

  const PortOptions& options_;
  std::optional<OutDir> out_dir_;
  std::optional<UndoPatch> undo_;
  bool has_written_ = false;
  std::set<std::string> outside_git_;     ///< files to write that git could not bring back
  std::vector<std::string> overwritten_;  ///< those of them that were written
  std::string unsaved_;  ///< why the undo patch could not be saved; empty: it was, or not needed
};

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "port/writing.h"

namespace tzc::rewriter {

/// What a user types to apply an undo patch in a folder.
std::string undo_command(const std::string& folder, const std::string& patch);

/// The patch that takes a port back: one file for a run, saved before each package is written, so that an
/// interrupted run can be taken back as well.
class UndoPatch {
 public:
  /// `file`: where the user wants it, opened at once; empty: a new file in $XDG_STATE_HOME/tzc/undo (else
  /// ~/.local/state), made when something is written. `packages`: all that the run may write.
  static Expected<UndoPatch> open(const std::string& file, const std::vector<std::string>& packages);

  /// Adds packages that are about to be written at once. An error leaves what was saved before.
  Expected<void> add(const WriteUnit& unit);

  /// Takes the last ones out again: they were not written.
  void drop_last();

  /// What the user types; empty: there is nothing to undo.
  std::string command() const;

 private:
  UndoPatch() = default;
  Expected<void> save() const;
  std::string part_for(const PackagePort& port) const;

  std::string file_;    ///< empty: no place yet
  std::string folder_;  ///< that the patch's paths are relative to
  std::vector<std::string> parts_;
};

}  // namespace tzc::rewriter

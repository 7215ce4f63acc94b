// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "tool/package_port.h"

namespace tzc::rewriter {

/// The patch that takes a port back: one file for a run, saved before each package is written, so that an
/// interrupted run can be taken back as well.
class UndoPatch {
 public:
  /// `file`: where the user wants it, opened at once; empty: a new file in $XDG_STATE_HOME/tzc/undo (else
  /// ~/.local/state), made when something is written. `packages`: all that the run may write.
  static Expected<UndoPatch> open(const std::string& file, const std::vector<std::string>& packages);

  /// Adds a package that is about to be written. An error leaves what was saved before.
  Expected<void> add(const PackagePort& port);

  /// Takes the last package out again: it was not written.
  void drop_last();

  /// What the user types; empty: there is nothing to undo.
  std::string command() const;

 private:
  UndoPatch() = default;
  Expected<void> save() const;

  std::string file_;    ///< empty: no place yet
  std::string folder_;  ///< that the patch's paths are relative to
  std::vector<std::string> parts_;
};

}  // namespace tzc::rewriter

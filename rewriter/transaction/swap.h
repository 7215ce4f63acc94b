// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "edits/files.h"
#include "model/edit.h"
#include "model/expected.h"

// stage: PACKAGE/.tzc-rewrite/{lock, 0, 1, ...}      an interrupted run leaves the package untouched
//   └── journal.json appears (one rename)            ── the point of no return ──
//         └── each staged file renamed over its target, folder removed
//                                                    an interrupted run is finished by the next start

namespace tzc::rewriter {

/// Replaces files of one package, all of them or none: SIGINT and SIGTERM wait until the swap is over; after
/// a SIGKILL or a power cut recover() finishes it. `before` is what the new contents were derived from: a
/// difference to the files on disk is an error and nothing is written. Modes are kept.
Expected<void> swap_in(const std::string& package_dir, const FileContents& contents, const Snapshot& before);

/// Whether a swap of this package has passed its point of no return and is not finished: recover() will do that.
bool is_swap_unfinished(const std::string& package_dir);

/// To be called at every start: finishes a swap that was interrupted after its point of no return, removes
/// the traces of one that was interrupted before it. Returns the files that it replaced. An error when
/// another run holds the package, or when a file was changed in between.
Expected<std::vector<std::string>> recover(const std::string& package_dir);

/// For tests: called with "staged", "journal" and "swapped" (after each file).
extern void (*swap_observer)(const char* step);

}  // namespace tzc::rewriter

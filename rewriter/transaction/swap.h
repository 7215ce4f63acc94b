// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <string>
#include <vector>

#include "edits/files.h"
#include "model/edit.h"
#include "model/expected.h"

// stage: FOLDER/.tzc-rewrite/{lock, 0, 1, ...}       an interrupted run leaves the packages untouched
//   └── journal.json appears (one rename)            ── the point of no return ──
//         └── each staged file renamed over its target, folder removed
//                                                    an interrupted run is finished by the next start

namespace tzc::rewriter {

/// The new contents of files of a package, and what they were derived from.
struct PackageSwap {
  std::string package_dir;
  const FileContents& contents;
  const Snapshot& before;
};

/// Replaces files of packages, all of them or none: SIGINT and SIGTERM wait until the swap is over; after
/// a SIGKILL or a power cut recover() finishes it. A difference of `before` to the files on disk is an error and nothing
/// is written. Modes are kept. FOLDER is the package, or the deepest folder that holds all of them.
Expected<void> swap_in(const std::vector<PackageSwap>& packages);

/// Whether a swap of these packages has passed its point of no return and is not finished: recover() will do that.
bool is_swap_unfinished(const std::vector<std::string>& packages);

/// Where swaps of these packages, alone or with others, may be unfinished: the packages, and those folders above them
/// in which a run of this user left something. What others left there is not trusted: anybody may write to /tmp.
std::vector<std::string> swap_folders(const std::vector<std::string>& packages, uid_t user);

/// To be called at every start: finishes a swap that was interrupted after its point of no return, removes
/// the traces of one that was interrupted before it. Returns the files that it replaced. An error when
/// another run holds the folder, or when a file was changed in between.
Expected<std::vector<std::string>> recover(const std::string& folder);

/// For tests: called with "staged", "journal" and "swapped" (after each file).
extern void (*swap_observer)(const char* step);

}  // namespace tzc::rewriter

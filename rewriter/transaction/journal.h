// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/expected.h"

namespace tzc::rewriter {

struct JournalEntry {
  std::string staged, target;
  std::uint64_t old_hash = 0, new_hash = 0;
};
using Journal = std::vector<JournalEntry>;

std::string journal_path(const std::string& folder);

/// The journal while it is being written.
std::string unfinished_journal_path(const std::string& folder);

/// The journal appears whole or not at all. It names files relative to the package, so a package may be moved
/// in between.
Expected<void> write_journal(const std::string& folder, const Journal& journal);
Expected<Journal> read_journal(const std::string& folder);

}  // namespace tzc::rewriter

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>

#include "model/folder_set.h"
#include "model/level.h"
#include "model/site.h"

namespace tzc::rewriter {

/// The user's options that solving reads.
struct SolveOptions {
  FolderSet packages;                  ///< that are ported as one
  Level max_level = Level::zero_copy;  ///< zero_copy, one_copy or plain: how far publishers are ported
  OnExhausted on_exhausted = OnExhausted::deliver;
  std::uint64_t small = 4096;  ///< --small: messages whose arrays hold fewer bytes stay as they are
  std::optional<std::uint64_t> mem_size;                ///< --mem-size: bytes for each publisher
  std::map<std::string, std::uint64_t> measured_sizes;  ///< topic -> largest message of a recording, bytes
  SiteFilter wanted;                                    ///< empty: every site
};

}  // namespace tzc::rewriter

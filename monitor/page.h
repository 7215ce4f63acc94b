// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "model.h"

namespace tzc::monitor {

/// Copies bytes of a page from an offset; returns how many it copied (fewer: the page ends, or an error).
using ReadAt = std::function<std::size_t(void* to, std::size_t bytes, std::uint64_t offset)>;

/// What a page says: name, start, time, topics, and the writer's pid. Trusts nothing in it: sizes and counts are bounded,
/// texts end, and what is not printable ASCII becomes a question mark. False: it is no page of this version, or its
/// writer never held still; `trouble` says which.
bool read_page(const ReadAt& read_at, Node& node, std::string& trouble);

}  // namespace tzc::monitor

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace tzc {
namespace posix {

/// The kernel does not refuse memory to a control group that is full, it kills one of its processes; so
/// whoever is about to commit a lot asks first.
///
/// Bytes that this process's control groups (version 1 or 2, the tightest of them and their ancestors) still
/// allow, page cache that the kernel could drop counted as free. SIZE_MAX when there is no limit, or none
/// that can be read. Reads a few small files. `root` is put before every path: a test's own tree.
std::size_t memory_headroom(const std::string& root = "");

}  // namespace posix
}  // namespace tzc

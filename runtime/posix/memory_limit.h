// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace tzc {
namespace posix {

/// The kernel does not refuse memory to a control group or a machine that is full, it kills a process; so
/// a process that is about to commit a lot asks first.
///
/// Bytes that the machine (memory and swap) and this process's control groups (version 1 or 2, the tightest of
/// them and their ancestors) still allow, page cache that the kernel could drop counted as free. SIZE_MAX when
/// nothing of it can be read. Reads a few small files. `root` is put before every path: a test's own tree.
std::size_t memory_headroom(const std::string& root = "");

}  // namespace posix
}  // namespace tzc

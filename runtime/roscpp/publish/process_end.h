// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

namespace tzc {
namespace detail {

/// True when no thread of the process runs its program any more: it has ended, or the kernel closes its sockets one
/// after the other. False also where the kernel does not tell (no /proc, a process of another PID namespace). Any thread.
bool has_ended(pid_t process);

}  // namespace detail
}  // namespace tzc

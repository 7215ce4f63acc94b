// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>

namespace tzc {
namespace channel {

/// \name The signals of faults, for transports (posix/fault_signals.h)
/// @{
sigset_t all_but_faults() noexcept;
/// Before the program's code sees a message on a thread that has not taken it (posix/write_fault.h).
void keep_watching_write_faults();
/// @}

}  // namespace channel
}  // namespace tzc

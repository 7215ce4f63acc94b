// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>

namespace tzc {
namespace channel {

/// \name The signals of faults, for transports (posix/fault_signals.h)
/// @{
sigset_t all_but_faults() noexcept;
void unblock_faults() noexcept;
/// @}

}  // namespace channel
}  // namespace tzc

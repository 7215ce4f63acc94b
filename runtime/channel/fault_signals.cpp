// SPDX-License-Identifier: BSD-3-Clause
#include "channel/fault_signals.h"

#include "posix/fault_signals.h"
#include "posix/write_fault.h"

namespace tzc {
namespace channel {

sigset_t all_but_faults() noexcept {
  return posix::all_but_faults();
}

void keep_watching_write_faults() {
  posix::keep_watching_write_faults();
}

}  // namespace channel
}  // namespace tzc

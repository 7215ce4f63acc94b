// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>

namespace tzc {
namespace posix {

/// While it lives, a file that grows beyond `ulimit -f` is an error (EFBIG) in this thread and no SIGXFSZ, which ends
/// the process. A signal that was pending before stays pending.
class SizeSignalBlocked {
 public:
  SizeSignalBlocked() noexcept;
  ~SizeSignalBlocked();
  SizeSignalBlocked(const SizeSignalBlocked&) = delete;
  SizeSignalBlocked& operator=(const SizeSignalBlocked&) = delete;

 private:
  sigset_t before_;
  bool was_pending_;
};

}  // namespace posix
}  // namespace tzc

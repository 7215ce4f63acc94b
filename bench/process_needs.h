// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <string>

namespace tzc {
namespace bench {

/// A field of /proc/PID/status in KB. "RssAnon": the process's own memory; "RssShmem": pages of shared files.
std::size_t status_kb(pid_t process, const std::string& field);

/// What a process has of what a system has not without end.
struct Needs {
  std::size_t threads = 0;
  std::size_t descriptors = 0;
  std::size_t private_kb = 0;
  std::size_t shared_kb = 0;  ///< pages of memory files that it has mapped
};

/// All zero when the process is gone.
Needs needs_of(pid_t process);

/// The greater one, each by itself.
Needs most(const Needs& a, const Needs& b);

}  // namespace bench
}  // namespace tzc

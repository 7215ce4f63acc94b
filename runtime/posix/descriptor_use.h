// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

namespace tzc {
namespace posix {

/// How many descriptors this process may have (RLIMIT_NOFILE). Thread-safe, as all of this.
std::size_t descriptor_limit() noexcept;

/// Whether TZC may keep a descriptor that it opened just now. Seven eighths of a process's descriptors may be in use then: the others
/// are left to the program, whose own sockets and files do not have another way to go, as a message has. The number of
/// a new descriptor tells, which is the lowest that was free.
bool leaves_enough(int newest) noexcept;
/// Whether it might keep one that it opened now. Also true where something else than the number of descriptors would prevent that:
/// what needs one then says what. Three system calls, no file.
bool has_spare_descriptors() noexcept;
/// Why it may not, for messages to users: "more than seven eighths of the 1024 file descriptors ... are in use".
std::string descriptors_in_use();

}  // namespace posix
}  // namespace tzc

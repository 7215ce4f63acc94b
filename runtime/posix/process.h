// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

namespace tzc {
namespace posix {

std::uint32_t process_number() noexcept;
/// What ps shows.
std::string program_name();

/// The calling thread's number, as ps and debuggers show it; after the first call on a thread it costs one load. A
/// forked child keeps its parent's. In the portable build, a number of this process's own.
std::uint32_t thread_number() noexcept;
/// The name of a thread of this process; empty when it has ended, and in the portable build.
std::string thread_name(std::uint32_t thread);

}  // namespace posix
}  // namespace tzc

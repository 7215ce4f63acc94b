// SPDX-License-Identifier: BSD-3-Clause
#include <unistd.h>

#include <atomic>

#include "posix/process.h"

namespace tzc {
namespace posix {

std::uint32_t process_number() noexcept {
  return static_cast<std::uint32_t>(::getpid());
}

std::string program_name() {
  return "process " + std::to_string(process_number());
}

std::uint32_t thread_number() noexcept {
  static std::atomic<std::uint32_t> threads{0};
  thread_local const std::uint32_t number = ++threads;
  return number;
}

std::string thread_name(std::uint32_t) {
  return std::string();
}

}  // namespace posix
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include <sys/syscall.h>
#include <unistd.h>

#include <fstream>

#include "posix/process.h"

namespace tzc {
namespace posix {
namespace {

std::string first_line(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  std::getline(file, line);
  return line;
}

}  // namespace

std::uint32_t process_number() noexcept {
  return static_cast<std::uint32_t>(::getpid());
}

std::string program_name() {
  return first_line("/proc/self/comm");
}

std::uint32_t thread_number() noexcept {
  thread_local const auto number = static_cast<std::uint32_t>(::syscall(SYS_gettid));
  return number;
}

std::string thread_name(std::uint32_t thread) {
  return first_line("/proc/self/task/" + std::to_string(thread) + "/comm");
}

}  // namespace posix
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <dirent.h>
#include <signal.h>
#include <sys/types.h>

#include <chrono>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>

namespace tzc_test {

inline bool is_stopped_thread(const std::string& thread) {
  std::ifstream stat(thread + "/stat");
  const std::string text{std::istreambuf_iterator<char>(stat), std::istreambuf_iterator<char>()};
  const std::size_t name_end = text.rfind(')');
  return name_end == std::string::npos || text.compare(name_end, 3, ") T") == 0;
}

inline bool is_stopped(pid_t process) {
  const std::string threads = "/proc/" + std::to_string(process) + "/task/";
  const std::unique_ptr<DIR, int (*)(DIR*)> directory(opendir(threads.c_str()), closedir);
  while (const dirent* entry = directory ? readdir(directory.get()) : nullptr)
    if (entry->d_name[0] != '.' && !is_stopped_thread(threads + entry->d_name)) return false;
  return true;
}

/// Stops another process, and returns when its last thread has stopped: until then it might still answer.
inline void stop(pid_t process) {
  kill(process, SIGSTOP);
  while (!is_stopped(process)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

}  // namespace tzc_test

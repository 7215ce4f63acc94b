// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/process_end.h"

#include <dirent.h>
#include <signal.h>

#include <cerrno>
#include <fstream>
#include <memory>
#include <sstream>
#include <string>

namespace tzc {
namespace detail {
namespace {

constexpr unsigned long exiting_flag =
    0x4;  // PF_EXITING of include/linux/sched.h; set before a file is closed

// The flags are the ninth field (proc(5)). The second is the name, which may hold spaces and parentheses.
bool is_exiting(const std::string& stat_file) {
  std::ifstream file(stat_file);
  if (!file) return errno == ENOENT;
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return true;  // the thread has gone
  std::istringstream fields(line.substr(name_end + 1));
  std::string skipped;
  for (int i = 0; i < 6; ++i) fields >> skipped;
  unsigned long flags = 0;
  fields >> flags;
  return (flags & exiting_flag) != 0;
}

}  // namespace

bool has_ended(pid_t process) {
  if (process <= 0) return false;
  if (::kill(process, 0) != 0 && errno == ESRCH) return true;
  const std::string folder = "/proc/" + std::to_string(process) + "/task";
  const std::unique_ptr<DIR, int (*)(DIR*)> threads(::opendir(folder.c_str()), ::closedir);
  if (!threads) return false;
  while (const dirent* entry = ::readdir(threads.get())) {
    if (entry->d_name[0] != '.' && !is_exiting(folder + "/" + entry->d_name + "/stat")) return false;
  }
  return true;
}

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "run/process_tree.h"

#include <dirent.h>
#include <unistd.h>

#include <cctype>
#include <cstdlib>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>

#include "pairing/recording.h"

namespace tzc::compare {
namespace {

struct Stat {
  pid_t parent = 0;
  unsigned long long ticks = 0;  ///< user and system time
};

/// From /proc/PID/stat; the fields are counted from behind the program's name, which may contain blanks.
Stat read_stat(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return {};
  std::istringstream fields(line.substr(name_end + 1));
  std::string skipped;
  Stat stat;
  unsigned long long user = 0, system = 0;
  fields >> skipped >> stat.parent;
  for (int i = 0; i < 9; ++i) fields >> skipped;
  fields >> user >> system;
  stat.ticks = user + system;
  return stat;
}

std::map<pid_t, std::vector<pid_t>> all_children() {
  std::map<pid_t, std::vector<pid_t>> children;
  const std::unique_ptr<DIR, int (*)(DIR*)> folder(::opendir("/proc"), ::closedir);
  while (const dirent* entry = folder ? ::readdir(folder.get()) : nullptr) {
    if (!std::isdigit(static_cast<unsigned char>(entry->d_name[0]))) continue;
    const auto pid = static_cast<pid_t>(std::atoi(entry->d_name));
    children[read_stat(pid).parent].push_back(pid);
  }
  return children;
}

std::string base_name(const std::string& path) {
  return path.substr(path.rfind('/') + 1);
}

bool is_helper_program(const std::string& name) {
  static const std::set<std::string> names{"bash",       "sh",          "roslaunch", "rosrun", "rospack",
                                           "rosversion", "catkin_find", "find",      "uniq",   "grep"};
  return names.count(name) != 0;
}

/// "" for what is not counted.
std::string name_of(pid_t pid) {
  std::ifstream file("/proc/" + std::to_string(pid) + "/cmdline");
  std::string argument, program;
  bool is_helper = false;
  for (int i = 0; std::getline(file, argument, '\0'); ++i) {
    if (argument.rfind("__name:=", 0) == 0) return without_anonymous_part(argument.substr(8));
    const std::string base = base_name(argument);
    is_helper = is_helper || (i < 2 && is_helper_program(base));
    if (i == 0 || (i == 1 && program.rfind("python", 0) == 0)) program = base;
  }
  return is_helper ? "" : program;
}

}  // namespace

std::vector<pid_t> children_of(pid_t parent) {
  return all_children()[parent];
}

void CpuMeter::sample(const std::vector<pid_t>& roots) {
  const auto children = all_children();
  for (const pid_t root : roots) visit(root, children);
}

void CpuMeter::visit(pid_t pid, const std::map<pid_t, std::vector<pid_t>>& children) {
  Usage& usage = usage_[pid];
  const std::string name = name_of(pid);
  if (!name.empty() || usage.name.empty()) usage.name = name;  // a shell may have become the program by exec
  usage.ticks = std::max(usage.ticks, read_stat(pid).ticks);
  const auto found = children.find(pid);
  if (found == children.end()) return;
  for (const pid_t child : found->second) visit(child, children);
}

std::map<std::string, double> CpuMeter::seconds() const {
  const auto per_second = static_cast<double>(::sysconf(_SC_CLK_TCK));
  std::map<std::string, double> all;
  for (const auto& [pid, usage] : usage_)
    if (!usage.name.empty()) all[usage.name] += static_cast<double>(usage.ticks) / per_second;
  return all;
}

}  // namespace tzc::compare

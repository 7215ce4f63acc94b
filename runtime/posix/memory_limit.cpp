// SPDX-License-Identifier: BSD-3-Clause
// Control groups as the kernel documents them: admin-guide/cgroup-v1/memory.rst and
// admin-guide/cgroup-v2.rst; the machine's memory as filesystems/proc.rst does (meminfo).
#include "posix/memory_limit.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <vector>

namespace tzc {
namespace posix {
namespace {

/// Where a hierarchy that limits memory is mounted, and how its files are called.
struct Hierarchy {
  std::string mount;
  std::string mounted_root;  // the group that is seen at `mount`
  const char* limit;
  const char* usage;
  const char* cache_prefix;  // of the lines in memory.stat that include the groups below
};

bool is_memory_v1(const std::string& type, const std::string& options) {
  return type == "cgroup" && ("," + options + ",").find(",memory,") != std::string::npos;
}

// "36 35 98:0 /root /mount options... - type source super-options"
bool parse_mount(const std::string& line, Hierarchy& found) {
  const std::size_t dash = line.find(" - ");
  if (dash == std::string::npos) return false;
  std::istringstream before(line.substr(0, dash)), after(line.substr(dash + 3));
  std::string skipped, root, mount, type, source, options;
  before >> skipped >> skipped >> skipped >> root >> mount;
  after >> type >> source >> options;
  if (type == "cgroup2") {
    found = Hierarchy{mount, root, "memory.max", "memory.current", ""};
  } else if (is_memory_v1(type, options)) {
    found = Hierarchy{mount, root, "memory.limit_in_bytes", "memory.usage_in_bytes", "total_"};
  } else {
    return false;
  }
  return true;
}

// "0::/path" in version 2, "4:memory:/path" in version 1.
std::string group_of(const Hierarchy& hierarchy, const std::string& root) {
  const bool second = hierarchy.cache_prefix[0] == '\0';
  std::ifstream groups(root + "/proc/self/cgroup");
  for (std::string line; std::getline(groups, line);) {
    const std::size_t first = line.find(':'), last = line.find(':', first + 1);
    if (last == std::string::npos) continue;
    const std::string controllers = "," + line.substr(first + 1, last - first - 1) + ",";
    if (second ? controllers == ",," : controllers.find(",memory,") != std::string::npos)
      return line.substr(last + 1);
  }
  return "/";
}

/// The number in a file, or SIZE_MAX: "max" in version 2, and a huge one in version 1.
std::size_t read_number(const std::string& path) {
  std::ifstream file(path);
  std::uint64_t value = 0;
  return file >> value ? static_cast<std::size_t>(value) : SIZE_MAX;
}

std::size_t droppable_cache(const std::string& folder, const std::string& prefix) {
  std::ifstream stat(folder + "/memory.stat");
  std::string name;
  std::uint64_t value = 0, sum = 0;
  while (stat >> name >> value) {
    if (name == prefix + "inactive_file" || name == prefix + "active_file") sum += value;
  }
  return static_cast<std::size_t>(sum);
}

std::size_t headroom_of(const std::string& folder, const Hierarchy& hierarchy) {
  constexpr std::size_t no_limit = SIZE_MAX / 4;  // version 1 rounds its largest number down to pages
  const std::size_t limit = read_number(folder + "/" + hierarchy.limit);
  if (limit >= no_limit) return SIZE_MAX;
  const std::size_t usage = read_number(folder + "/" + hierarchy.usage);
  if (usage == SIZE_MAX) return SIZE_MAX;
  const std::size_t used = usage - std::min(usage, droppable_cache(folder, hierarchy.cache_prefix));
  return limit - std::min(limit, used);
}

// Every group up to the mount limits the process.
std::size_t tightest(const Hierarchy& hierarchy, const std::string& root) {
  std::string group = group_of(hierarchy, root);
  if (hierarchy.mounted_root != "/" &&
      group.compare(0, hierarchy.mounted_root.size(), hierarchy.mounted_root) == 0)
    group.erase(0, hierarchy.mounted_root.size());
  std::size_t least = SIZE_MAX;
  for (;;) {
    least = std::min(least, headroom_of(root + hierarchy.mount + group, hierarchy));
    const std::size_t slash = group.rfind('/');
    if (group.empty() || slash == std::string::npos) return least;
    group.erase(slash);
  }
}

/// What the kernel could give without ending a process: a memory file lies in memory or in swap.
std::size_t headroom_of_the_machine(const std::string& root) {
  constexpr std::size_t unit = 1024;  // the file says kB and means this
  std::ifstream meminfo(root + "/proc/meminfo");
  bool known = false;
  std::uint64_t sum = 0, value = 0;
  for (std::string name; meminfo >> name >> value; meminfo.ignore(32, '\n')) {
    known = known || name == "MemAvailable:";
    if (name == "MemAvailable:" || name == "SwapFree:") sum += value;
  }
  return known ? static_cast<std::size_t>(sum) * unit : SIZE_MAX;
}

}  // namespace

std::size_t memory_headroom(const std::string& root) {
  std::size_t least = headroom_of_the_machine(root);
  std::ifstream mounts(root + "/proc/self/mountinfo");
  for (std::string line; std::getline(mounts, line);) {
    Hierarchy hierarchy;
    if (parse_mount(line, hierarchy)) least = std::min(least, tightest(hierarchy, root));
  }
  return least;
}

}  // namespace posix
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "cost.h"

#include <fstream>
#include <sstream>
#include <string>

namespace tzc {
namespace bench {
namespace {

// Fields 10 and 12 of /proc/PID/stat: faults without and with reading a disk. Field 2, a name in parentheses,
// may contain spaces.
std::uint64_t page_faults_of(pid_t process) {
  std::ifstream file("/proc/" + std::to_string(process) + "/stat");
  std::string line;
  std::getline(file, line);
  const std::size_t name_end = line.rfind(')');
  if (name_end == std::string::npos) return 0;
  std::istringstream rest(line.substr(name_end + 1));
  std::string ignored;
  for (int field = 3; field < 10; ++field) rest >> ignored;
  std::uint64_t minor = 0, major = 0;
  rest >> minor >> ignored >> major;
  return minor + major;
}

}  // namespace

Cost cost_of(pid_t process, const Counts& counts) {
  return {counts.sent, counts.received, counts.copied, page_faults_of(process)};
}

Cost operator-(const Cost& after, const Cost& before) {
  return {after.sent_bytes - before.sent_bytes, after.received_bytes - before.received_bytes,
          after.copied_bytes - before.copied_bytes, after.page_faults - before.page_faults};
}

Cost& operator+=(Cost& sum, const Cost& more) {
  sum.sent_bytes += more.sent_bytes;
  sum.received_bytes += more.received_bytes;
  sum.copied_bytes += more.copied_bytes;
  sum.page_faults += more.page_faults;
  return sum;
}

}  // namespace bench
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "cost.h"

#include <fcntl.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>

namespace tzc {
namespace bench {
namespace {

// Fields 10 and 12 of /proc/PID/stat: faults without and with reading a disk. Field 2, a name in parentheses,
// may contain spaces. Allocates nothing: a process that looks at itself must not count that.
std::uint64_t page_faults_of(pid_t process) {
  char path[64], text[1024];
  std::snprintf(path, sizeof path, "/proc/%d/stat", static_cast<int>(process));
  const int fd = ::open(path, O_RDONLY | O_CLOEXEC);
  const ssize_t size = fd >= 0 ? ::read(fd, text, sizeof text - 1) : -1;
  ::close(fd);
  if (size <= 0) return 0;
  text[size] = '\0';
  const char* const name_end = std::strrchr(text, ')');
  unsigned long minor = 0, major = 0;
  if (name_end == nullptr ||
      std::sscanf(name_end + 1, " %*s %*d %*d %*d %*d %*d %*u %lu %*u %lu", &minor, &major) != 2)
    return 0;
  return minor + major;
}

}  // namespace

Cost cost_of(pid_t process, const Counts& counts) {
  return {counts.sent, counts.received, counts.copied, page_faults_of(process), counts.allocations};
}

Cost operator-(const Cost& after, const Cost& before) {
  return {after.sent_bytes - before.sent_bytes, after.received_bytes - before.received_bytes,
          after.copied_bytes - before.copied_bytes, after.page_faults - before.page_faults,
          after.allocations - before.allocations};
}

Cost& operator+=(Cost& sum, const Cost& more) {
  sum.sent_bytes += more.sent_bytes;
  sum.received_bytes += more.received_bytes;
  sum.copied_bytes += more.copied_bytes;
  sum.page_faults += more.page_faults;
  sum.allocations += more.allocations;
  return sum;
}

}  // namespace bench
}  // namespace tzc

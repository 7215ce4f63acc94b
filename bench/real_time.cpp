// SPDX-License-Identifier: BSD-3-Clause
#include "real_time.h"

#include <malloc.h>
#include <sched.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include "processes.h"

namespace tzc {
namespace bench {
namespace {

constexpr int priority = 50;  // below the kernel's own threads for interrupts
constexpr rlim_t longest_run_us = 500'000;

// malloc gives nothing back to the kernel and maps nothing by itself, so that no page is faulted in again.
void keep_memory() {
  ::mallopt(M_TRIM_THRESHOLD, -1);
  ::mallopt(M_MMAP_MAX, 0);
}

void touch_stack() {
  volatile char stack[256 << 10];
  for (std::size_t at = 0; at < sizeof stack; at += 1024) stack[at] = 0;
}

}  // namespace

bool become_real_time() {
  const rlimit longest{longest_run_us, longest_run_us};
  const sched_param scheduling{priority};
  if (::setrlimit(RLIMIT_RTTIME, &longest) != 0) return false;
  if (::mlockall(MCL_CURRENT | MCL_FUTURE) != 0) return false;
  if (::sched_setscheduler(0, SCHED_FIFO, &scheduling) != 0) return ::munlockall(), false;
  ::prctl(PR_SET_TIMERSLACK, 1);
  keep_memory();
  touch_stack();
  return true;
}

std::string real_time_obstacle() {
  const pid_t child = in_child([] {
    if (!become_real_time()) ::_exit(1);
    ::_exit(0);
  });
  if (wait_for(child) == Ending::exited) return "";
  return "SCHED_FIFO or locked memory is not permitted: run as root, or raise the limits rtprio (to 50) and "
         "memlock "
         "(to unlimited) in /etc/security/limits.conf";
}

}  // namespace bench
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/transport_thread.h"

#include <pthread.h>
#include <ros/init.h>

#include <exception>
#include <new>
#include <string>
#include <utility>

#include "channel/fault_signals.h"
#include "channel/small_thread.h"
#include "roscpp/before_exit.h"
#include "roscpp/throttled_warning.h"

namespace tzc {
namespace detail {
namespace {

void block_other_signals() {
  const sigset_t others = channel::all_but_faults();
  pthread_sigmask(SIG_BLOCK, &others, nullptr);
}

template <class Warn>
void warn_if_possible(Warn warn) {
  try {
    warn();
  } catch (const std::exception&) {
    return;  // without memory there may be none for the warning, either
  }
}

bool no_thread(const std::string& why) {
  warn_if_possible([&why] {
    TZC_WARN_THROTTLED(60, "TZC: connections stay on TCPROS: no thread can be started ("
                               << why << "); raise the limit (ulimit -u, or pids.max of the cgroup)");
  });
  return false;
}

}  // namespace

bool start_small_transport_thread(const char* name, std::function<void()> body) {
  try {
    const Status started = channel::start_small_thread(name, std::move(body));
    return started || no_thread(started.error().text());
  } catch (const std::exception& error) {
    return no_thread(error.what());
  }
}

bool start_transport_thread(std::thread& thread, std::function<void()> body) {
  try {
    thread = std::thread([body = std::move(body)] {
      block_other_signals();
      body();
    });
    return true;
  } catch (const std::exception& error) {
    return no_thread(error.what());
  }
}

void run_job(std::function<void()> job) {
  const BeforeExit step;
  auto own = std::move(job);  // destroyed inside the step
  if (!step) return static_cast<void>(new (std::nothrow) std::function<void()>(std::move(own)));
  try {
    own();
  } catch (const std::exception& error) {
    // A job may run while the process ends, when roscpp's and the log's own locks are destroyed already.
    if (ros::isShuttingDown()) return;
    warn_if_possible(
        [&error] { TZC_WARN_THROTTLED(60, "TZC: a connection stays on TCPROS: " << error.what()); });
  }
}

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "run/stop_request.h"

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>

#include "run/failure.h"

namespace tzc::compare {
namespace {

volatile sig_atomic_t is_stopped = 0;

// Async-signal-safe. Nodes may take some seconds to end: whoever pressed Ctrl-C is told that it was seen.
void note(int) {
  constexpr char text[] = "\ntzc-compare: stopping what was started\n";
  if (is_stopped == 0) (void)!::write(STDERR_FILENO, text, sizeof text - 1);
  is_stopped = 1;
}

/// As nohup and a script's `&` have it.
bool is_ignored(int signal) {
  struct sigaction action{};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

}  // namespace

void watch_for_stop_requests() {
  struct sigaction action{};
  action.sa_handler = note;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT})
    if (!is_ignored(signal)) ::sigaction(signal, &action, nullptr);
  ::signal(SIGPIPE, SIG_IGN);  // a recorder that has died shows as an error of write()
}

void check_for_stop_request() {
  if (is_stopped) throw Stopped();
}

void sleep_ms(int milliseconds) {
  constexpr int step_ms = 20;  // a signal between the test and the sleep is seen after one step
  for (int left = milliseconds; left > 0; left -= step_ms) {
    check_for_stop_request();
    const timespec step{0, std::min(left, step_ms) * 1'000'000L};
    ::nanosleep(&step, nullptr);
  }
  check_for_stop_request();
}

}  // namespace tzc::compare

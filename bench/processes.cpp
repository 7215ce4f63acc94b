// SPDX-License-Identifier: BSD-3-Clause
#include "processes.h"

#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <thread>

namespace tzc {
namespace bench {
namespace {

bool holding = false;
bool was_interrupted = false;

sigset_t held_signals() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&signals, signal);
  return signals;
}

void become_a_child(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it died before the line above
  ::signal(SIGINT, SIG_IGN);
  const sigset_t signals = held_signals();
  ::sigprocmask(SIG_UNBLOCK, &signals, nullptr);
}

bool runs(pid_t child) {
  siginfo_t ended{};
  return ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == 0;
}

void note(int signal) {
  if (signal == SIGINT || signal == SIGTERM) was_interrupted = true;
}

}  // namespace

pid_t in_child(const std::function<void()>& body) {
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child != 0) return child;
  become_a_child(parent);
  body();
  std::exit(0);  // iceoryx cleans its socket files up in a destructor
}

// Blocked signals wait until sigwaitinfo takes them, so that none is lost between a look and a wait.
void hold_interrupts() {
  const sigset_t signals = held_signals();
  ::sigprocmask(SIG_BLOCK, &signals, nullptr);
  holding = true;
}

bool interrupted() {
  if (!holding) return false;
  sigset_t signals = held_signals();
  sigdelset(&signals, SIGCHLD);
  const timespec at_once{};
  for (int signal = 0; (signal = ::sigtimedwait(&signals, nullptr, &at_once)) > 0;) note(signal);
  return was_interrupted;
}

Ending wait_for(pid_t child) {
  const sigset_t signals = held_signals();
  for (int status = 0;;) {
    const pid_t ended = ::waitpid(child, &status, holding ? WNOHANG : 0);
    if (ended == child)
      return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::exited : Ending::failed;
    if (ended < 0 && errno != EINTR) return Ending::failed;
    if (holding && interrupted()) return Ending::interrupted;
    if (holding && ended == 0) note(::sigwaitinfo(&signals, nullptr));
  }
}

bool all_run(const std::vector<pid_t>& children) {
  return std::all_of(children.begin(), children.end(), runs);
}

void let_end(const std::vector<pid_t>& children, std::chrono::milliseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  while (std::any_of(children.begin(), children.end(), runs) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(std::chrono::milliseconds(10));
}

void stop(const std::vector<pid_t>& children) {
  for (const pid_t child : children) ::kill(child, SIGKILL);
  for (const pid_t child : children) ::waitpid(child, nullptr, 0);
}

}  // namespace bench
}  // namespace tzc

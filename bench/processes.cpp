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
#include <iterator>
#include <system_error>
#include <thread>

namespace tzc {
namespace bench {
namespace {

using Handler = void (*)(int);

constexpr std::chrono::milliseconds a_moment{10};
// A terminal sends these to every process of the benchmark.
constexpr int from_terminal[] = {SIGINT, SIGHUP, SIGQUIT};

bool holding = false;
bool was_interrupted = false;
sigset_t held;  // where holding
Handler of_parent[std::size(from_terminal)] = {};

bool is_ignored(int signal) {
  struct sigaction action{};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

sigset_t signals_to_hold() {
  sigset_t signals;
  sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGCHLD}) sigaddset(&signals, signal);
  for (const int signal : {SIGHUP, SIGQUIT})
    if (!is_ignored(signal)) sigaddset(&signals, signal);
  return signals;
}

void become_a_child(pid_t parent) {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(1);  // it died before the line above
  for (std::size_t i = 0; i < std::size(from_terminal); ++i)
    of_parent[i] = ::signal(from_terminal[i], SIG_IGN);
  if (holding) ::sigprocmask(SIG_UNBLOCK, &held, nullptr);
  holding = false;
}

/// noexcept: the parent's frames lie below, and what is caught there must not make a second parent of a child.
[[noreturn]] void run_child(pid_t parent, const std::function<void()>& body) noexcept {
  become_a_child(parent);
  body();
  std::exit(0);  // iceoryx cleans its socket files up in a destructor
}

bool runs(pid_t child) {
  siginfo_t ended{};
  return ::waitid(P_PID, static_cast<id_t>(child), &ended, WEXITED | WNOHANG | WNOWAIT) == 0 &&
         ended.si_pid == 0;
}

void note(int signal) {
  if (signal > 0 && signal != SIGCHLD) was_interrupted = true;
}

}  // namespace

pid_t in_child(const std::function<void()>& body) {
  ::signal(SIGCHLD, SIG_DFL);  // a starter may have left it ignored: then children end without a trace
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), "cannot start a process");
  if (child == 0) run_child(parent, body);
  return child;
}

std::vector<pid_t> in_children(std::size_t count, const std::function<void(std::size_t number)>& body) {
  std::vector<pid_t> children;
  children.reserve(count);
  try {
    for (std::size_t number = 0; number < count; ++number)
      children.push_back(in_child([&] { body(number); }));
  } catch (const std::system_error&) {
    stop(children);
    throw;
  }
  return children;
}

void take_interrupts_again() {
  for (std::size_t i = 0; i < std::size(from_terminal); ++i) ::signal(from_terminal[i], of_parent[i]);
}

// Blocked signals wait until sigwaitinfo takes them, so that none is lost between a look and a wait.
void hold_interrupts() {
  held = signals_to_hold();
  ::sigprocmask(SIG_BLOCK, &held, nullptr);
  holding = true;
}

bool interrupted() {
  if (!holding) return false;
  sigset_t signals = held;
  sigdelset(&signals, SIGCHLD);
  const timespec at_once{};
  for (int signal = 0; (signal = ::sigtimedwait(&signals, nullptr, &at_once)) > 0;) note(signal);
  return was_interrupted;
}

void wait_for_news(std::chrono::milliseconds most) {
  if (!holding) return std::this_thread::sleep_for(std::min(most, a_moment));
  const timespec time{most.count() / 1000, most.count() % 1000 * 1'000'000};
  note(::sigtimedwait(&held, nullptr, &time));
}

Ending wait_for(pid_t child) {
  if (child <= 0) return Ending::failed;  // waitpid would take any other child
  for (int status = 0;;) {
    const pid_t ended = ::waitpid(child, &status, holding ? WNOHANG : 0);
    if (ended == child)
      return WIFEXITED(status) && WEXITSTATUS(status) == 0 ? Ending::exited : Ending::failed;
    if (ended < 0 && errno != EINTR) return Ending::failed;
    if (holding && interrupted()) return Ending::interrupted;
    if (holding && ended == 0) note(::sigwaitinfo(&held, nullptr));
  }
}

bool all_run(const std::vector<pid_t>& children) {
  return std::all_of(children.begin(), children.end(), runs);
}

void let_end(const std::vector<pid_t>& children, std::chrono::milliseconds most) {
  const auto end = std::chrono::steady_clock::now() + most;
  while (std::any_of(children.begin(), children.end(), runs) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(a_moment);
}

void stop(const std::vector<pid_t>& children) {
  for (const pid_t child : children)
    if (child > 0) ::kill(child, SIGKILL);
  for (const pid_t child : children)
    if (child > 0) ::waitpid(child, nullptr, 0);
}

}  // namespace bench
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/soak.h"

#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <system_error>

#include "measure.h"
#include "processes.h"

namespace tzc {
namespace bench {
namespace {

constexpr useconds_t tick_us = 200'000;

/// True once in each period.
class Every {
 public:
  explicit Every(double seconds) : period_ns_(static_cast<std::int64_t>(seconds * 1e9)) {}
  bool due() {
    if (now_ns() < next_ns_) return false;
    next_ns_ += period_ns_;
    return true;
  }

 private:
  const std::int64_t period_ns_;
  std::int64_t next_ns_ = now_ns() + period_ns_;
};

void start(SoakProcess& process) {
  process.pid = -1;  // where that fails, the number may soon be another's
  process.pid = in_child([&process] { process.role->run(*process.counts); });
}

void stop_all(const std::vector<SoakProcess>& processes) {
  std::vector<pid_t> pids;
  for (const SoakProcess& process : processes) pids.push_back(process.pid);
  stop(pids);
}

/// The master asks whoever listens at the address of a node that another one of its name replaces to shut down. After a kill
/// that may be the other process that is killed, on the port that has become free: ROS's doing, as it would be on a robot.
bool was_asked_to_end(const SoakProcess& process, int status) {
  return process.role->fate == Fate::killed && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

void print_progress(double seconds, const std::vector<SoakProcess>& processes) {
  std::uint64_t published = 0, received = 0, spoiled = 0;
  Needs largest;
  for (const SoakProcess& process : processes) {
    published += process.counts->published;
    received += process.counts->received;
    spoiled += process.counts->spoiled;
    if (process.watched()) largest = most(largest, process.looks.back());
  }
  std::fprintf(stderr,
               "%6.1f min: published %llu, received %llu, spoiled %llu; the most of any: %zu threads, %zu "
               "descriptors, %zu KB private, %zu KB shared\n",
               seconds / 60, static_cast<unsigned long long>(published),
               static_cast<unsigned long long>(received), static_cast<unsigned long long>(spoiled),
               largest.threads, largest.descriptors, largest.private_kb, largest.shared_kb);
}

}  // namespace

Soak::Soak(const SoakPlan& plan) : plan_(plan), start_ns_(now_ns()) {
  const auto& roles = soak_roles();
  void* memory = ::mmap(nullptr, sizeof(SoakCounts) * roles.size(), PROT_READ | PROT_WRITE,
                        MAP_SHARED | MAP_ANONYMOUS, -1, 0);
  if (memory == MAP_FAILED) {
    std::perror("tzc-bench soak: memory for the processes' counts");
    return;
  }
  for (std::size_t i = 0; i < roles.size(); ++i)
    processes_.push_back({&roles[i], new (static_cast<SoakCounts*>(memory) + i) SoakCounts()});
  try {
    for (SoakProcess& process : processes_) start(process);
  } catch (const std::system_error&) {
    stop_all(processes_);
    throw;
  }
}

Soak::~Soak() {
  stop_all(processes_);
}

double Soak::seconds() const {
  return static_cast<double>(now_ns() - start_ns_) / 1e9;
}

bool Soak::run() {
  try {
    return lasts();
  } catch (const std::system_error& error) {
    std::fprintf(stderr, "tzc-bench soak: %s\n", error.what());
    return false;
  }
}

bool Soak::lasts() {
  Every look(plan_.look_every_s), kill(plan_.kill_every_s), stopping(plan_.stop_for_s);
  while (seconds() < plan_.minutes * 60 && !interrupted()) {
    ::usleep(tick_us);
    if (ended_by_itself()) return false;
    if (kill.due()) replace_those_to_be_killed();
    if (stopping.due()) stop_or_continue();
    if (look.due()) look_at_all();
  }
  return !processes_.empty();
}

bool Soak::ended_by_itself() {
  for (SoakProcess& process : processes_) {
    int status = 0;
    if (process.pid <= 0 || ::waitpid(process.pid, &status, WNOHANG) != process.pid) continue;
    if (was_asked_to_end(process, status)) {
      start(process);
      continue;
    }
    std::fprintf(stderr, "tzc-bench soak: %s ended by itself\n", process.role->name);
    process.pid = -1;
    return true;
  }
  return false;
}

void Soak::replace_those_to_be_killed() {
  for (SoakProcess& process : processes_) {
    if (process.role->fate != Fate::killed) continue;
    stop({process.pid});
    ++process.killed;
    start(process);
  }
}

void Soak::stop_or_continue() {
  stopped_ = !stopped_;
  for (const SoakProcess& process : processes_)
    if (process.role->fate == Fate::stopped && process.pid > 0)
      ::kill(process.pid, stopped_ ? SIGSTOP : SIGCONT);
}

void Soak::look_at_all() {
  for (SoakProcess& process : processes_)
    if (process.watched()) process.looks.push_back(needs_of(process.pid));
  print_progress(seconds(), processes_);
}

}  // namespace bench
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/before_exit.h"

#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace tzc {
namespace detail {
namespace {

constexpr std::chrono::milliseconds longest_wait(1000), pause_between_looks(1);

// Never destroyed: threads look at them until the process is gone.
std::atomic<int> steps{0};
std::atomic<bool> has_begun{false};
std::atomic<pid_t> waiting_process{0};
thread_local int own_steps = 0;  // negative: a fiber has ended a step that another thread began

/// A callback that calls exit() is inside a step of its own thread. A forked child has none of the threads.
void wait_for_steps() {
  if (::getpid() != waiting_process) return;
  has_begun = true;
  const auto end = std::chrono::steady_clock::now() + longest_wait;
  while (steps > std::max(own_steps, 0) && std::chrono::steady_clock::now() < end)
    std::this_thread::sleep_for(pause_between_looks);
}

/// Handlers run in the opposite order: this one comes before roscpp's, which is there since the node was started.
void ask_exit_to_wait() {
  static const bool asked = [] {
    waiting_process = ::getpid();
    return std::atexit(wait_for_steps) == 0;
  }();
  static_cast<void>(asked);
}

bool begin_step() {
  ask_exit_to_wait();
  ++own_steps;
  ++steps;
  return !has_begun;
}

}  // namespace

BeforeExit::BeforeExit() : may_run_(begin_step()) {}

BeforeExit::~BeforeExit() {
  --steps;
  --own_steps;
}

bool exit_has_begun() {
  return has_begun;
}

}  // namespace detail
}  // namespace tzc

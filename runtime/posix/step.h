// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace tzc {
namespace posix {

using StepHook = void (*)(const char* step);

/// A test may have itself called between any two steps of allocate, publish, take, release and the move between TCPROS
/// and shared memory, for example to be killed there, or to hold one thread until another has come to some step. Null in production: one predicted branch on a cached load.
extern std::atomic<StepHook> step_hook;

inline void step(const char* name) {
  const StepHook hook = step_hook.load(std::memory_order_relaxed);
  if (__builtin_expect(hook != nullptr, 0)) hook(name);
}

}  // namespace posix
}  // namespace tzc

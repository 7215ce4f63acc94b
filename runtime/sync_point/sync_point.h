// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>

namespace tzc {

using SyncPointHook = void (*)(const char* name);

/// A test's function that is called at every sync_point, for example to kill the process there, or to hold one
/// thread until another has come to some point. Null in production.
extern std::atomic<SyncPointHook> sync_point_hook;

/// A point between two steps of allocate, publish, take, release, or of the move between TCPROS and shared memory.
/// Costs one predicted branch on a cached load. `name` is "operation: step".
inline void sync_point(const char* name) {
  const SyncPointHook hook = sync_point_hook.load(std::memory_order_relaxed);
  if (__builtin_expect(hook != nullptr, 0)) hook(name);
}

}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc {
namespace detail {

/// A step of a thread of the transport, or of roscpp's poll thread, on objects of roscpp and of the program. exit() destroys both while such
/// threads run: roscpp's handler (init.cpp, atexitCallback) leaves the subscriptions alone, "because they are already destroyed".
/// So the first step asks exit() to wait for the steps of all other threads, at most a second, before anything is destroyed
/// that was there then; no later one begins. What the program makes later (a static object in a callback) is destroyed before the wait: C++ asks for
/// that order, and what comes before all of it, the end of the thread's own objects (thread_local), does not tell exit() from the end of a
/// thread. No harm to messages in it: their handles keep their memory mapped, and no static object of the runtime that they use is ever
/// destroyed. What a callback on another thread does with it then is the program's to prevent, as with roscpp's threaded spinners
/// (docs/roscpp.md#at-exit).
/// Any thread; two atomic additions. A step may be inside another.
class BeforeExit {
 public:
  BeforeExit();
  ~BeforeExit();
  BeforeExit(const BeforeExit&) = delete;
  BeforeExit& operator=(const BeforeExit&) = delete;

  /// False: exit() has begun, and nothing may be touched that it destroys.
  explicit operator bool() const { return may_run_; }

 private:
  const bool may_run_;
};

/// For a step that waits for somebody else: it should give up.
bool exit_has_begun();

}  // namespace detail
}  // namespace tzc

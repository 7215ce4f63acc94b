// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <signal.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstring>

// What the processes of the crash test share: anonymous memory that outlives each of them.

namespace tzc {
namespace crash {

constexpr int subscribers = 3;
constexpr int publisher = subscribers;  // roles: subscribers 0 to 2, then the publisher
constexpr int roles = subscribers + 1;
constexpr std::size_t memory_size = 4 << 20;

enum class Phase : int {
  run,      ///< publish, take, hold, release
  quiesce,  ///< release everything; the publisher proves that all its memory is free
};

struct Board {
  std::atomic<Phase> phase;
  std::atomic<std::uint64_t> received[subscribers];
  std::atomic<std::int64_t> all_free_since;  // set by the publisher while quiescing
  std::atomic<int> connections;              // as the publisher sees it
  std::atomic<int> errors;

  std::atomic<int> aimed_role;  // the role that dies at a step; -1: none
  std::atomic<int> aimed_step;
  std::atomic<int> steps_left;
  std::atomic<std::int64_t> died_at;
  char address[64];
};

constexpr const char* publisher_steps[] = {
    "allocate: begin",      "allocate: placed", "allocate: reclaimed",    "allocate: revoking",
    "publish: before mark", "publish: marked",  "publish: before write",  "publish: slot filled",
    "publish: before bell", "publish: written", "publish: revoke decided"};
constexpr const char* subscriber_steps[] = {"take: slot copied", "take: before cursors", "take: record won",
                                            "take: block taken", "release: block",       "release: released"};

inline std::int64_t now_ns() {
  timespec now{};
  ::clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<std::int64_t>(now.tv_sec) * 1'000'000'000 + now.tv_nsec;
}

/// The board and the role of this process; for the step hook, which takes no argument.
extern Board* board;
extern int own_role;

void run_publisher(unsigned seed);
void run_subscriber(unsigned seed);

inline void report_error(const char* what) {
  std::fprintf(stderr, "crash_test: role %d, pid %d: %s\n", own_role, static_cast<int>(::getpid()), what);
  ++board->errors;
}

}  // namespace crash
}  // namespace tzc

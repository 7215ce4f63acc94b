// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "tzc/error.h"

namespace tzc {
namespace posix {

/// Waits for many descriptors at once. watch, change, forget and wake may be called from any thread while
/// another one waits; they take effect at once. Level triggered.
class Poller {
 public:
  struct Event {
    std::uint64_t key = 0;
    bool readable = false;  ///< something to read, or the peer stopped sending
    bool writable = false;
    bool hung_up = false;  ///< both directions are closed: the peer is gone
  };

  static Expected<std::unique_ptr<Poller>> create();
  virtual ~Poller() = default;

  virtual Status watch(int fd, std::uint64_t key, bool readable, bool writable) = 0;
  virtual void change(int fd, std::uint64_t key, bool readable, bool writable) = 0;
  virtual void forget(int fd) = 0;
  /// Makes a wait that runs now, or else the next one, return.
  virtual void wake() = 0;
  /// Fills `events` (emptied first); -1: no time limit. Returns without events when woken or interrupted.
  virtual void wait(int timeout_ms, std::vector<Event>& events) = 0;
};

}  // namespace posix
}  // namespace tzc

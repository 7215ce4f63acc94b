// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>
#include <tzc/channel.h>
#include <unistd.h>

#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace tzc {
namespace detail {

/// The nodes behind the connections of a channel, for warnings. Knows what their links own, as there are thousands. Thread-safe.
class SubscriberNames {
 public:
  /// Both live until remove().
  void add(channel::Connection& connection, const std::string& node);
  void remove(const channel::Connection& connection);
  /// "/viewer 3, /recorder 10": the subscribers with records in flight, and how many. Empty when there are
  /// none.
  std::string in_flight() const;

 private:
  mutable std::mutex mutex_;
  std::vector<std::pair<channel::Connection*, const std::string*>> names_;
  const pid_t process_ =
      ::getpid();  ///< a forked child's exit must not wait for a mutex that a thread of its parent held
};

}  // namespace detail
}  // namespace tzc

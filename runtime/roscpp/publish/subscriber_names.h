// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/channel.h>

#include <map>
#include <mutex>
#include <string>

namespace tzc {
namespace detail {

/// The nodes behind the connections of a channel, for warnings. Thread-safe.
class SubscriberNames {
 public:
  void add(const channel::ConnectionPtr& connection, const std::string& node);
  void remove(const channel::ConnectionPtr& connection);
  /// "/viewer 3, /recorder 10": the subscribers with records in flight, and how many. Empty when there are
  /// none.
  std::string in_flight() const;

 private:
  mutable std::mutex mutex_;
  std::map<channel::ConnectionPtr, std::string> names_;
};

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <mutex>
#include <set>
#include <string>

namespace tzc {
namespace detail {

/// Which nodes the user has been told about. Bounded, as nodes with names of their own may come and go for months.
/// Thread-safe.
class ToldPeers {
 public:
  explicit ToldPeers(std::size_t limit) : limit_(limit) {}

  /// True the first time for each peer, and never again once there have been as many as the limit.
  bool is_new(const std::string& peer);

 private:
  const std::size_t limit_;
  std::mutex mutex_;
  std::set<std::string> peers_;
};

/// Warns, once for each node, that it has another version of TZC, so that what goes between it and this node stays on
/// TCPROS. Thread-safe.
void warn_of_other_version(const std::string& peer, const std::string& topic);

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/transport_subscriber_link.h>

#include <algorithm>
#include <chrono>
#include <optional>
#include <vector>

namespace tzc {
namespace detail {

/// One link or another, which may be gone. Locks neither: to drop the last reference to a link runs user callbacks.
template <class Link>
bool is_same(const boost::weak_ptr<ros::TransportSubscriberLink>& one, const Link& other) {
  return !one.owner_before(other) && !other.owner_before(one);
}

/// The links whose subscribers have accepted an invitation, and what counts should they be lost. There are thousands, each for as
/// long as its connection, so their invitations are not kept. Not thread-safe.
class AcceptedLinks {
 public:
  using Clock = std::chrono::steady_clock;
  struct Accepted {
    boost::weak_ptr<ros::TransportSubscriberLink> link;
    Clock::time_point at;
    int tries;
    bool warned;
  };

  /// Also forgets those that are gone.
  void add(Accepted accepted) {
    const auto is_over = [](const Accepted& one) { return one.link.expired(); };
    links_.erase(std::remove_if(links_.begin(), links_.end(), is_over), links_.end());
    links_.push_back(std::move(accepted));
  }
  template <class Link>
  bool has(const Link& link) const {
    return std::any_of(links_.begin(), links_.end(),
                       [&](const Accepted& one) { return is_same(one.link, link); });
  }
  /// Nothing: it is not one of them.
  template <class Link>
  std::optional<Accepted> take(const Link& link) {
    const auto found = std::find_if(links_.begin(), links_.end(),
                                    [&](const Accepted& one) { return is_same(one.link, link); });
    if (found == links_.end()) return std::nullopt;
    Accepted accepted = std::move(*found);
    links_.erase(found);
    return accepted;
  }

 private:
  std::vector<Accepted> links_;
};

}  // namespace detail
}  // namespace tzc

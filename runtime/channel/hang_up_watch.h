// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include "channel/service.h"

namespace tzc {
namespace channel {

class Link;

/// Tells a link when the other end of its socket is closed, whose reader sleeps on the ring and not on the
/// socket.
class HangUpWatch final : public Watcher {
 public:
  static Expected<std::shared_ptr<HangUpWatch>> start(Service& service, int fd, Link& link);
  HangUpWatch(Service& service, int fd, Link& link) : service_(service), fd_(fd), link_(&link) {}
  /// Afterwards neither the link nor its descriptor is used. Waits for nobody's callbacks.
  void stop();

  void on_event(const posix::Poller::Event& event) override;

 private:
  void forget();

  Service& service_;
  const int fd_;
  std::mutex mutex_;
  Link* link_;
  std::uint64_t key_ = 0;
};

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <mutex>

#include "channel/wait/service.h"

namespace tzc {
namespace channel {

/// Told when the other end of a socket is closed.
class HangUpListener {
 public:
  virtual ~HangUpListener() = default;
  virtual void end() = 0;
};

/// Tells a link that the other end of its socket is closed. Its reader sleeps on the ring and does not see
/// that.
class HangUpWatch final : public Watcher {
 public:
  static Expected<std::shared_ptr<HangUpWatch>> start(Service& service, int fd, HangUpListener& listener);
  HangUpWatch(Service& service, int fd, HangUpListener& listener)
      : service_(service), fd_(fd), listener_(&listener) {}
  /// Afterwards neither the listener nor its descriptor is used. Waits for no callback.
  void stop();

  void on_event(const posix::Poller::Event& event) override;

 private:
  void forget();

  Service& service_;
  const int fd_;
  std::mutex mutex_;
  HangUpListener* listener_;
  std::uint64_t key_ = 0;
};

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>

#include "channel/wait/service.h"
#include "segment/private_views.h"

namespace tzc {
namespace channel {

/// Tells a subscriber, once, that code of its process writes to received messages. The write is noticed in a signal
/// handler, which may call nearly nothing; the callback runs on the service thread, or on the reader's, whichever comes
/// first. Thread-safe.
class WriteNotice final : public segment::WriteListener, public Callee {
 public:
  /// `service` null: only give() calls. `on_write` null: nothing is called.
  static std::shared_ptr<WriteNotice> create(Service* service, std::function<void()> on_write);
  WriteNotice(Service* service, std::function<void()> on_write)
      : service_(service), on_write_(std::move(on_write)) {}

  void first_write() noexcept override;
  /// Calls back when it is time.
  void give() {
    if (due_.load(std::memory_order_relaxed) && due_.exchange(false)) call();
  }
  void on_call() override { give(); }
  /// Afterwards the callback is not called any more; one that runs on another thread has returned.
  void stop();

 private:
  void call();

  Service* const service_;
  const std::function<void()> on_write_;
  std::atomic<bool> due_{false};
  std::atomic<bool> noticed_{false};
  std::recursive_mutex mutex_;  // the callback may end its subscriber
  bool done_ = false;
};

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "channel/subscribe/write_notice.h"

#include <utility>

namespace tzc {
namespace channel {

std::shared_ptr<WriteNotice> WriteNotice::create(Service* service, std::function<void()> on_write) {
  const bool is_heard = service != nullptr && on_write;
  auto notice = std::make_shared<WriteNotice>(service, std::move(on_write));
  if (is_heard) service->add_callee(notice);
  return notice;
}

// A store to an atomic and a write to the service's descriptor: async-signal-safe.
void WriteNotice::first_write() noexcept {
  if (!on_write_ || noticed_.exchange(true, std::memory_order_relaxed)) return;
  due_.store(true, std::memory_order_release);
  if (service_ != nullptr) service_->call_all();
}

void WriteNotice::call() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  if (done_) return;
  done_ = true;
  on_write_();
}

void WriteNotice::stop() {
  const std::lock_guard<std::recursive_mutex> lock(mutex_);
  done_ = true;
}

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "channel/wait/hang_up_watch.h"

namespace tzc {
namespace channel {

Expected<std::shared_ptr<HangUpWatch>> HangUpWatch::start(Service& service, int fd,
                                                          HangUpListener& listener) {
  auto watch = std::make_shared<HangUpWatch>(service, fd, listener);
  const std::lock_guard<std::mutex> lock(watch->mutex_);
  const auto key = service.add(fd, false, false, watch);
  if (!key) return key.error();
  watch->key_ = *key;
  return {std::move(watch)};
}

void HangUpWatch::stop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  forget();
}

// Stop watching: the poller would report the hang-up again and again.
void HangUpWatch::on_event(const posix::Poller::Event& event) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!event.hung_up || listener_ == nullptr) return;
  listener_->end();
  forget();
}

void HangUpWatch::forget() {
  if (listener_ == nullptr) return;
  listener_ = nullptr;
  service_.forget(fd_, key_);
}

}  // namespace channel
}  // namespace tzc

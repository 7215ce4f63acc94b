// SPDX-License-Identifier: BSD-3-Clause
#include "channel/hang_up_watch.h"

#include "channel/link.h"

namespace tzc {
namespace channel {

Expected<std::shared_ptr<HangUpWatch>> HangUpWatch::start(Service& service, int fd, Link& link) {
  auto watch = std::make_shared<HangUpWatch>(service, fd, link);
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

// Once is enough: the poller would report it again and again.
void HangUpWatch::on_event(const posix::Poller::Event& event) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!event.hung_up || link_ == nullptr) return;
  link_->end();
  forget();
}

void HangUpWatch::forget() {
  if (link_ == nullptr) return;
  link_ = nullptr;
  service_.forget(fd_, key_);
}

}  // namespace channel
}  // namespace tzc

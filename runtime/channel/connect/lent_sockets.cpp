// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/lent_sockets.h"

#include <utility>

#include "posix/socket.h"

namespace tzc {
namespace channel {

void LentSockets::are_lent() {
  const std::lock_guard<std::mutex> lock(mutex_);
  lent_ = true;
}

bool LentSockets::lent() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return lent_;
}

int LentSockets::current() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return current_.get();
}

bool LentSockets::lend(posix::FileDescriptor socket) {
  const std::lock_guard<std::mutex> lock(mutex_);
  missed_ = missed_ || !socket;
  if (!socket || (current_ && next_)) return false;
  if (stopped_) posix::stop_receiving(socket.get());
  (current_ ? next_ : current_) = std::move(socket);
  return true;
}

bool LentSockets::missed() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return missed_;
}

bool LentSockets::give_back() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!lent_ || !current_) return false;
  current_ = std::move(next_);
  return true;
}

void LentSockets::stop_receiving() {
  const std::lock_guard<std::mutex> lock(mutex_);
  stopped_ = true;
  if (current_) posix::stop_receiving(current_.get());
  if (next_) posix::stop_receiving(next_.get());
}

}  // namespace channel
}  // namespace tzc

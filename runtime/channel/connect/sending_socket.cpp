// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/sending_socket.h"

#include <utility>

#include "posix/socket.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::chrono::milliseconds usual_patience{50};
constexpr std::chrono::milliseconds short_patience{2};
constexpr std::chrono::milliseconds pause_before_lending_again{20};

}  // namespace

SendingSocket::SendingSocket(posix::FileDescriptor socket, std::unique_ptr<TrunkPlace> place)
    : is_loan_(place != nullptr), socket_(std::move(socket)), place_(std::move(place)) {}

// Through a loan the subscriber sends nothing.
Status SendingSocket::start(Service& service, std::shared_ptr<Watcher> watcher,
                            std::weak_ptr<TrunkListener> listener) {
  const auto key = service.add(socket_.get(), !is_loan_, false, std::move(watcher));
  if (!key) return key.error();
  service_ = &service;
  key_ = *key;
  // On the service thread, so the trunk is not lost meanwhile.
  if (place_) place_->listen(std::move(listener));
  return Success{};
}

int SendingSocket::open() {
  if (!socket_ && place_ && !broken_off_) lend();
  return socket_.get();
}

void SendingSocket::lend() {
  auto room = place_->trunk().loans().take(key_);
  if (!room) return;
  posix::SocketPair pair = posix::make_socket_pair();
  if (!pair.ours || !service_->watch(pair.ours.get(), key_, false, false))
    return call_at(Service::Clock::now() + pause_before_lending_again);
  socket_ = std::move(pair.ours);
  room_ = std::move(room);
  writable_watched_ = false;
  place_->lend(std::move(pair.theirs), room_);
  call_at(Service::Clock::now() + patience());
}

void SendingSocket::watch_writable(bool full) {
  if (service_ == nullptr || !socket_) return;
  if (full != writable_watched_) service_->change(socket_.get(), key_, !is_loan_, full);
  writable_watched_ = full;
}

void SendingSocket::call_at(Service::Clock::time_point when) {
  if (service_ != nullptr) service_->set_deadline(key_, when);
}

std::chrono::milliseconds SendingSocket::patience() const {
  return place_ && place_->trunk().loans().is_scarce() ? short_patience : usual_patience;
}

bool SendingSocket::is_wanted() const {
  return place_ && place_->trunk().loans().is_wanted();
}

void SendingSocket::stop_reading() {
  service_->change(socket_.get(), key_, false, false);
}

// Its end is seen also while a forked child has a copy of the socket.
void SendingSocket::give_up() {
  if (!socket_) return;
  service_->unwatch(socket_.get());
  posix::stop_sending(socket_.get());
  socket_.reset();
  room_.reset();
}

bool SendingSocket::end() {
  const bool counts = static_cast<bool>(socket_);
  if (place_) {
    give_up();
    place_->tell(TrunkWord::end);
  } else {
    posix::stop_sending(socket_.get());
  }
  return counts;
}

void SendingSocket::break_off() {
  broken_off_ = true;
  is_loan_ ? call_at(Service::Clock::now()) : posix::disconnect(socket_.get());
}

void SendingSocket::close() {
  broken_off_ = true;
  service_->remove(socket_.get(), key_);
  socket_.reset();
  room_.reset();
  place_.reset();
}

}  // namespace channel
}  // namespace tzc

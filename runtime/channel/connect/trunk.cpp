// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/trunk.h"

#include <cstring>
#include <utility>
#include <vector>

#include "posix/fork_epoch.h"
#include "posix/packet.h"
#include "posix/socket.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

using posix::SendResult;

constexpr int words_per_event = 64;
constexpr std::chrono::milliseconds pause_before_telling_again{20};

SendResult send_word(int socket, const WordPacket& packet, const posix::FileDescriptor& lent) {
  const iovec whole{const_cast<WordPacket*>(&packet), sizeof packet};
  const int descriptor = lent.get();
  return posix::send_packet(socket, &whole, 1, &descriptor, lent ? 1 : 0);
}

}  // namespace

TrunkPlace::TrunkPlace(std::shared_ptr<Trunk> trunk, std::uint32_t number)
    : trunk_(std::move(trunk)), number_(number) {}

TrunkPlace::~TrunkPlace() {
  trunk_->leave(number_);
}

bool TrunkPlace::listen(std::weak_ptr<TrunkListener> listener) {
  return trunk_->listen(number_, std::move(listener));
}

void TrunkPlace::tell(TrunkWord word) {
  trunk_->tell({{PacketKind::word, word, number_}});
}

void TrunkPlace::lend(posix::FileDescriptor socket, std::shared_ptr<LoanRoom::Taken> room) {
  trunk_->tell({{PacketKind::word, TrunkWord::lend, number_}, std::move(socket), std::move(room)});
}

Expected<std::shared_ptr<Trunk>> Trunk::start(Service& service, posix::FileDescriptor socket,
                                              const End& end) {
  auto trunk = std::make_shared<Trunk>(service, std::move(socket), end);
  const Status watched = trunk->watch();
  if (!watched) return watched.error();
  return {std::move(trunk)};
}

Trunk::Trunk(Service& service, posix::FileDescriptor socket, const End& end)
    : service_(service),
      end_(end),
      epoch_(posix::fork_epoch()),
      loans_(service, end.takes),
      socket_(std::move(socket)) {}

Status Trunk::watch() {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto key = service_.add(socket_.get(), true, false, shared_from_this());
  if (!key) return key.error();
  key_ = *key;
  return Success{};
}

std::unique_ptr<TrunkPlace> Trunk::take(std::uint32_t number) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!socket_ || !listeners_.emplace(number, std::weak_ptr<TrunkListener>()).second) return nullptr;
  return std::make_unique<TrunkPlace>(shared_from_this(), number);
}

std::unique_ptr<TrunkPlace> Trunk::take_any() {
  if (posix::forked_since(epoch_)) return nullptr;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!socket_) return nullptr;
  do ++last_number_;
  while (!listeners_.emplace(last_number_, std::weak_ptr<TrunkListener>()).second);
  return std::make_unique<TrunkPlace>(shared_from_this(), last_number_);
}

bool Trunk::listen(std::uint32_t number, std::weak_ptr<TrunkListener> listener) {
  const std::lock_guard<std::mutex> lock(mutex_);
  listeners_[number] = std::move(listener);
  return static_cast<bool>(socket_);
}

bool Trunk::is_unused() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return listeners_.empty();
}

void Trunk::leave(std::uint32_t number) {
  if (posix::forked_since(epoch_)) return;  // the parent's lock may be in any state, and it uses the socket
  const std::lock_guard<std::mutex> lock(mutex_);
  listeners_.erase(number);
  close_if_unused();
}

void Trunk::tell(Said said) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!socket_) return;
  waiting_.push_back(std::move(said));
  if (waiting_.size() == 1) flush();
}

// Where the other process is gone, the hang-up says so to the service thread.
void Trunk::flush() {
  SendResult result = SendResult::sent;
  while (!waiting_.empty() && result == SendResult::sent) {
    result = send_word(socket_.get(), waiting_.front().packet, waiting_.front().socket);
    if (result == SendResult::sent) waiting_.pop_front();
  }
  if (result == SendResult::gone) waiting_.clear();
  watch_writable(result == SendResult::full);
  if (result == SendResult::exhausted)
    service_.set_deadline(key_, Service::Clock::now() + pause_before_telling_again);
}

void Trunk::watch_writable(bool full) {
  if (full != full_) service_.change(socket_.get(), key_, true, full);
  full_ = full;
}

void Trunk::close_if_unused() {
  if (socket_ && end_.closes_unused && listeners_.empty() && waiting_.empty()) close();
}

// The other process sees a hang-up then, also while a forked child has a copy of the socket.
void Trunk::close() {
  service_.forget(socket_.get(), key_);
  posix::disconnect(socket_.get());
  socket_.reset();
  waiting_.clear();
}

void Trunk::on_deadline() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!socket_) return;
  flush();
  close_if_unused();
}

void Trunk::on_event(const posix::Poller::Event& event) {
  if (event.writable) on_deadline();
  if (!event.readable && !event.hung_up) return;
  bool open = true;
  for (int i = 0; i < words_per_event; ++i) {
    if (!hear_one(open)) break;
  }
  if (!open) lose();
}

// Only the service thread closes the socket while words come, or somebody who wants no more of them.
bool Trunk::hear_one(bool& open) {
  WordPacket word{};
  posix::ReceivedPacket packet;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (!socket_) return false;
    const auto result = posix::receive_packet(socket_.get(), &word, sizeof word,
                                              posix::Waiting::return_at_once, true, packet);
    if (result == posix::ReceiveResult::nothing) return false;
    open = result == posix::ReceiveResult::packet && packet.size == sizeof word && !packet.truncated &&
           word.kind == PacketKind::word;
    if (!open) return false;
  }
  hear(word, std::move(packet.descriptors[0]));
  return true;
}

void Trunk::hear(const WordPacket& packet, posix::FileDescriptor socket) {
  sync_point("trunk: hears");
  std::shared_ptr<TrunkListener> listener;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = listeners_.find(packet.number);
    if (found != listeners_.end()) listener = found->second.lock();
  }
  if (listener) listener->heard(packet.word, std::move(socket));
}

void Trunk::lose() {
  std::map<std::uint32_t, std::weak_ptr<TrunkListener>> listeners;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (socket_) close();
    listeners = listeners_;  // their numbers stay theirs
  }
  for (const auto& one : listeners) {
    if (const auto listener = one.second.lock()) listener->trunk_lost();
  }
}

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/entrance.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include "channel/connect/publisher_address.h"
#include "posix/address.h"
#include "posix/fork_epoch.h"
#include "posix/nonce.h"

namespace tzc {
namespace channel {
namespace {

constexpr int accepts_per_event = 16;
constexpr std::chrono::milliseconds pause_before_accepting_again{100};

/// What the service keeps in place of the entrance, which would otherwise listen for ever.
class Doorman final : public Watcher {
 public:
  explicit Doorman(std::weak_ptr<Entrance> entrance) : entrance_(std::move(entrance)) {}
  void on_event(const posix::Poller::Event&) override {
    if (const auto entrance = entrance_.lock()) entrance->accept_some();
  }
  void on_deadline() override {
    if (const auto entrance = entrance_.lock()) entrance->resume();
  }

 private:
  const std::weak_ptr<Entrance> entrance_;
};

struct OfProcess {
  std::mutex mutex;
  std::weak_ptr<Entrance> entrance;
};

OfProcess& known() {
  static auto* const one = new OfProcess;  // never destroyed: publishers may live until the end
  return *one;
}

void turn_away(PeerAdmission& admission, int socket) {
  admission.count_refused_peer();
  refuse(socket, "only processes of the publisher's user may subscribe");
}

}  // namespace

// A forked child leaves its parent's alone: its lock may be in any state, and the parent answers there.
Expected<std::shared_ptr<Entrance>> Entrance::of_process() {
  OfProcess& of_process = known();
  const std::lock_guard<std::mutex> lock(of_process.mutex);
  auto entrance = of_process.entrance.lock();
  if (entrance && !posix::forked_since(entrance->epoch_)) return {std::move(entrance)};
  posix::remove_dead_sockets();
  auto opened = open(posix::generate_address(), true);
  if (opened) of_process.entrance = *opened;
  return opened;
}

Expected<std::shared_ptr<Entrance>> Entrance::at(const std::string& address) {
  const auto parsed = parse_publisher_address(address);
  if (!parsed) return parsed.error();
  if (parsed->publication == 0) return open(address, false);
  Error error;
  error.what = "listen";
  error.where = address;
  error.hint = "an address that a publisher is given has no '#', which separates publishers of one socket";
  return error;
}

Expected<std::shared_ptr<Entrance>> Entrance::open(const std::string& address, bool numbered) {
  const auto service = Service::instance();
  if (!service) return service.error();
  auto listener = posix::Listener::listen(address);
  if (!listener) return listener.error();
  auto entrance = std::make_shared<Entrance>(std::move(*listener), **service, numbered);
  const Status started = entrance->start();
  if (!started) return started.error();
  return {std::move(entrance)};
}

Entrance::Entrance(posix::Listener listener, Service& service, bool numbered)
    : listener_(std::move(listener)), service_(service), numbered_(numbered), epoch_(posix::fork_epoch()) {}

// Waits for no call: one that runs keeps the entrance.
Entrance::~Entrance() {
  if (!posix::forked_since(epoch_)) service_.forget(listener_.fd(), key_);
}

Status Entrance::start() {
  const auto key = service_.add(listener_.fd(), true, false, std::make_shared<Doorman>(weak_from_this()));
  if (!key) return key.error();
  key_ = *key;
  return Success{};
}

std::uint64_t Entrance::enter(std::weak_ptr<PeerAdmission> publisher) {
  const std::lock_guard<std::mutex> lock(mutex_);
  std::uint64_t number = 0;
  while (numbered_ && (number == 0 || publishers_.count(number) != 0)) number = posix::random_number();
  publishers_[number] = std::move(publisher);
  return number;
}

void Entrance::leave(std::uint64_t number) {
  const std::lock_guard<std::mutex> lock(mutex_);
  publishers_.erase(number);
}

std::string Entrance::address_of(std::uint64_t number) const {
  return to_text({listener_.address(), number});
}

// Without descriptors the listener would report the same peer at once again: stop watching for a moment.
void Entrance::accept_some() {
  for (int i = 0; i < accepts_per_event; ++i) {
    posix::FileDescriptor socket;
    switch (posix::accept_connection(listener_.fd(), socket)) {
      case posix::AcceptResult::accepted:
        greet(std::move(socket));
        break;
      case posix::AcceptResult::nothing:
        return;
      case posix::AcceptResult::exhausted:
        count_accept_failure();
        service_.change(listener_.fd(), key_, false, false);
        service_.set_deadline(key_, Service::Clock::now() + pause_before_accepting_again);
        return;
    }
  }
}

void Entrance::resume() {
  service_.change(listener_.fd(), key_, true, false);
}

// Nobody waits for what a user has to say whom no publisher would admit.
void Entrance::greet(posix::FileDescriptor socket) {
  const auto credentials = posix::peer_credentials(socket.get());
  if (!credentials || !considers(*credentials)) return turn_away(*this, socket.get());
  if (!PendingPeer::start(service_, std::move(socket), *credentials, weak_from_this()))
    count_accept_failure();
}

bool Entrance::considers(const Credentials& peer) const {
  const auto all = publishers();
  return std::any_of(all.begin(), all.end(),
                     [&peer](const auto& publisher) { return publisher->considers(peer); });
}

void Entrance::admit(posix::FileDescriptor socket, Peer peer) {
  if (peer.is_trunk) return trunks_.accept(service_, std::move(socket), peer);
  if (peer.trunk.id != 0 && !trunks_.place(peer))
    return refuse(socket.get(), "no such trunk is here any more");
  const auto publisher = find(peer.publication);
  if (!publisher) return refuse(socket.get(), "no such publisher is here any more");
  if (!publisher->considers(peer.credentials)) return turn_away(*publisher, socket.get());
  publisher->admit(std::move(socket), std::move(peer));
}

void Entrance::count_refused_peer() {
  for (const auto& publisher : publishers()) publisher->count_refused_peer();
}

void Entrance::count_accept_failure() {
  for (const auto& publisher : publishers()) publisher->count_accept_failure();
}

// The caller drops them without the lock: the last owner of a publisher may be this thread.
std::vector<std::shared_ptr<PeerAdmission>> Entrance::publishers() const {
  std::vector<std::shared_ptr<PeerAdmission>> alive;
  const std::lock_guard<std::mutex> lock(mutex_);
  for (const auto& one : publishers_)
    if (auto publisher = one.second.lock()) alive.push_back(std::move(publisher));
  return alive;
}

std::shared_ptr<PeerAdmission> Entrance::find(std::uint64_t number) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = publishers_.find(number);
  return found == publishers_.end() ? nullptr : found->second.lock();
}

}  // namespace channel
}  // namespace tzc

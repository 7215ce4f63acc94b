// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/connection.h"

#include "channel/wire/wire.h"
#include "posix/fork_epoch.h"
#include "posix/socket.h"
#include "segment/ack_word.h"
#include "sync_point/sync_point.h"
#include "trace/trace.h"

namespace tzc {
namespace channel {
namespace {

constexpr std::chrono::seconds linger{1};

InFlightLimit countable(InFlightLimit limit) {
  if (limit.records == 0 || limit.records > segment::max_ack_count) limit.records = segment::max_ack_count;
  return limit;
}

bool accepts_records(ConnectionState state) {
  return state == ConnectionState::corked || state == ConnectionState::open;
}

}  // namespace

ConnectionImpl::ConnectionImpl(posix::FileDescriptor socket, Peer peer, SharedPage page, Options options,
                               std::weak_ptr<ConnectionOwner> owner)
    : subscriber_{peer.credentials, std::move(peer.hello), peer.reads_ring},
      traced_as_(options.traced_as),
      owner_(std::move(owner)),
      epoch_(posix::fork_epoch()),
      page_(std::move(page)),
      window_(page_, segments_, countable(options.limit), options.keeps_undelivered),
      sender_(SendingSocket(std::move(socket), std::move(peer.trunk.place)),
              RingWriter(subscriber_.reads_ring ? &page_.ring() : nullptr, std::move(options.bell)),
              window_.limit().most() + 2 * max_segments) {}

Status ConnectionImpl::start(Service& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  return sender_.socket().start(service, shared_from_this(), weak_from_this());
}

std::uint32_t ConnectionImpl::granted_features() const {
  return (subscriber_.reads_ring ? std::uint32_t{reads_ring} : 0) |
         (sender_.socket().is_loan() ? std::uint32_t{has_trunk} : 0);
}

bool ConnectionImpl::alive() const {
  if (posix::forked_since(epoch_)) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  return accepts_records(state_);
}

bool ConnectionImpl::send(const RecordPtr& record) {
  if (!record || posix::forked_since(epoch_)) return false;
  if (trace::active) return send_traced(record);
  const std::lock_guard<std::mutex> lock(mutex_);
  return send_now(record);
}

bool ConnectionImpl::send_traced(const RecordPtr& record) {
  const std::uint64_t begin = trace::now();
  const std::lock_guard<std::mutex> lock(mutex_);
  const bool accepted = send_now(record);
  if (accepted)
    trace::record(trace::Step::publish, trace::Arrow::begins,
                  trace_id(page_.trace_number(), window_.last_sequence()), traced_as_, begin, record->size());
  return accepted;
}

bool ConnectionImpl::send_now(const RecordPtr& record) {
  if (!accepts_records(state_)) return false;
  if (!segments_.covers(*record)) {
    PacketSender::Result sent = PacketSender::Result::accepted;
    const Status announced = segments_.announce(*record, weak_from_this(), sender_, sent);
    heed(sent);
    if (!announced) failure_ = std::make_unique<Error>(announced.error());
    if (!announced || !accepts_records(state_)) return false;
  }
  if (window_.size() >= window_.limit().of_any_size()) heed_revocation(window_.make_room());
  if (!accepts_records(state_)) return false;
  sync_point("publish: before mark");
  window_.push(record);
  ++sent_;
  heed(sender_.send(record, window_.last_sequence()));
  return true;
}

void ConnectionImpl::heed(PacketSender::Result result) {
  if (result == PacketSender::Result::accepted) return;
  stop_deliveries();
  // A subscriber that is too slow reads the end of the stream and unsubscribes; it keeps what it holds.
  if (result == PacketSender::Result::too_slow) sender_.end_stream();
}

void ConnectionImpl::heed_revocation(bool honest) {
  honest ? sender_.drop_records_through(window_.revoked_through()) : abort();
}

void ConnectionImpl::uncork() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == ConnectionState::corked) state_ = ConnectionState::open;
  const Welcome welcome{PacketKind::welcome, wire_version, first_sequence,
                        static_cast<std::uint32_t>(page_.size()), granted_features()};
  const iovec whole{const_cast<Welcome*>(&welcome), sizeof welcome};
  const int page = page_.fd();
  if (posix::send_packet(sender_.socket().get(), &whole, 1, &page, 1) != posix::SendResult::sent)
    return abort();
  page_.close_descriptor();
  heed(sender_.uncork());
  sender_.rest();
}

void ConnectionImpl::revoke(const segment::BlockName& block) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ != ConnectionState::gone) heed_revocation(window_.revoke_block(block));
}

void ConnectionImpl::revoke_buffered() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ != ConnectionState::gone) heed_revocation(window_.revoke_buffered());
}

void ConnectionImpl::add_waiting(const segment::BlockName& block, std::vector<const void*>& handles) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  sender_.add_waiting(block, handles);
}

void ConnectionImpl::close() {
  if (posix::forked_since(epoch_)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!accepts_records(state_)) return;
  state_ = ConnectionState::draining;
  heed(sender_.end_by(Service::Clock::now() + linger));
}

// The socket of an honest subscriber stays open: it may hold blocks until it hangs up.
void ConnectionImpl::stop_deliveries() {
  state_ = ConnectionState::draining;
  if (!window_.end()) sender_.socket().break_off();
  sender_.drop_all();
}

// The subscriber broke the protocol: its claims to hold blocks do not count any more. The service thread sees
// the hang-up that this causes and cleans up.
void ConnectionImpl::abort() {
  state_ = ConnectionState::draining;
  sender_.drop_all();
  sender_.socket().break_off();
}

void ConnectionImpl::on_event(const posix::Poller::Event& event) {
  const bool loan = sender_.socket().is_loan();
  if (event.hung_up) return loan ? loan_closed() : hung_up();
  if (event.readable && !loan) return read_unsubscribe();  // the only packet that a subscriber sends
  on_deadline();
}

// The socket takes packets again, or it is time to try again, or to see whether a loan is still needed.
void ConnectionImpl::on_deadline() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == ConnectionState::gone) return;
    if (!sender_.socket().broken_off()) heed(sender_.flush());
    sender_.rest();
    if (!sender_.socket().is_loan() || !sender_.socket().broken_off()) return;
  }
  hung_up();  // what it held does not count
}

void ConnectionImpl::heard(TrunkWord word, posix::FileDescriptor) {
  if (word == TrunkWord::gone) return hung_up();
  if (word == TrunkWord::unsubscribe) unsubscribed();
}

// By a subscriber that is going; what becomes of it the trunk tells.
void ConnectionImpl::loan_closed() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == ConnectionState::gone) return;
  stop_deliveries();
  sender_.socket().give_up();
}

// Its Unsubscribe, the end of its stream, or an invalid packet: in each case nothing more is sent.
void ConnectionImpl::read_unsubscribe() {
  std::uint8_t byte = 0;
  posix::ReceivedPacket packet;
  const auto result = posix::receive_packet(sender_.socket().get(), &byte, sizeof byte,
                                            posix::Waiting::return_at_once, false, packet);
  if (result == posix::ReceiveResult::nothing) return;
  if (result == posix::ReceiveResult::closed) sender_.socket().stop_reading();
  unsubscribed();
}

void ConnectionImpl::unsubscribed() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == ConnectionState::gone) return;
    stop_deliveries();
    if (sender_.socket().is_loan())
      sender_.socket().give_up();  // it may keep messages, and read nothing any more
  }
  if (const auto owner = owner_.lock()) owner->disconnected(shared_from_this());
}

void ConnectionImpl::hung_up() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == ConnectionState::gone) return;
    stop_deliveries();
    state_ = ConnectionState::gone;
    segments_.clear();
    sender_.socket().close();
  }
  if (const auto owner = owner_.lock()) owner->disconnected(shared_from_this());
}

Error ConnectionImpl::last_failure() const {
  if (posix::forked_since(epoch_)) return Error();
  const std::lock_guard<std::mutex> lock(mutex_);
  return failure_ ? *failure_ : Error();
}

std::size_t ConnectionImpl::in_flight() {
  if (posix::forked_since(epoch_)) return 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (accepts_records(state_) && !window_.retire_taken()) abort();
  return window_.size();
}

std::size_t ConnectionImpl::held() const {
  return held_blocks().size();
}

// Looked for without the lock: a sender must not wait for it.
std::vector<HeldBlock> ConnectionImpl::held_blocks() const {
  std::vector<HeldBlock> held;
  if (posix::forked_since(epoch_)) return held;
  std::vector<std::shared_ptr<segment::AckFile>> files;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    files = segments_.ack_files();
  }
  for (const auto& file : files)
    file->for_each_taken([&](std::uint32_t slot, std::uint32_t generation) {
      held.push_back({file.get(), slot, generation});
    });
  return held;
}

ConnectionInspection ConnectionImpl::inspect() const {
  ConnectionInspection seen;
  seen.held = held_blocks();
  if (posix::forked_since(epoch_)) return seen;
  const std::lock_guard<std::mutex> lock(mutex_);
  seen.shared_bytes = window_.shared_bytes();
  seen.dropped_for_queue = window_.drops().queue;
  seen.dropped_for_memory = window_.drops().memory;
  seen.dropped_at_end = window_.drops().end;
  return seen;
}

// There is no other implementation.
ConnectionInspection inspect(const Connection& connection) {
  return static_cast<const ConnectionImpl&>(connection).inspect();
}

std::vector<RecordPtr> ConnectionImpl::take_undelivered() {
  if (posix::forked_since(epoch_)) return {};
  const std::lock_guard<std::mutex> lock(mutex_);
  return window_.take_undelivered();
}

ConnectionStats ConnectionImpl::stats() const {
  if (posix::forked_since(epoch_)) return ConnectionStats();
  const std::lock_guard<std::mutex> lock(mutex_);
  ConnectionStats stats;
  stats.sent = sent_;
  stats.dropped = window_.dropped();
  stats.bytes = sender_.bytes();
  stats.queued = sender_.waiting_records();
  stats.in_flight = window_.size();
  return stats;
}

}  // namespace channel
}  // namespace tzc

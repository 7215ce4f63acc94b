// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connection.h"

#include <algorithm>

#include "channel/hub.h"
#include "channel/received_message.h"
#include "posix/fork_epoch.h"
#include "posix/socket.h"
#include "posix/step.h"
#include "segment/ack_word.h"

namespace tzc {
namespace channel {
namespace {

using posix::SendResult;

constexpr std::chrono::seconds linger{1};
constexpr std::chrono::milliseconds pause_when_exhausted{20};

}  // namespace

ConnectionImpl::ConnectionImpl(posix::FileDescriptor socket, Peer peer, SharedPage page,
                               std::size_t queue_size, std::weak_ptr<Hub> hub, bool keeps_undelivered)
    : peer_(std::move(peer)),
      queue_size_(queue_size == 0 || queue_size > segment::max_ack_count ? segment::max_ack_count
                                                                         : queue_size),
      hub_(std::move(hub)),
      epoch_(posix::fork_epoch()),
      keeps_undelivered_(keeps_undelivered),
      socket_(std::move(socket)),
      page_(std::move(page)),
      ring_(peer_.reads_ring ? &page_.ring() : nullptr),
      last_sequence_(first_sequence) {}

Status ConnectionImpl::start(Service& service) {
  const std::lock_guard<std::mutex> lock(mutex_);
  service_ = &service;
  const auto key = service.add(socket_.get(), true, false, shared_from_this());
  if (!key) return key.error();
  key_ = *key;
  return Success{};
}

bool ConnectionImpl::alive() const {
  if (posix::forked_since(epoch_)) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  return accepts_records();
}

bool ConnectionImpl::send(const RecordPtr& record) {
  if (!record || posix::forked_since(epoch_)) return false;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!accepts_records() || !announce_segments(*record)) return false;
  if (undecided_.size() >= queue_size_) revoke_oldest_down_to(queue_size_ - 1);
  if (!accepts_records()) return false;
  posix::step("publish: before mark");
  claim(record);
  ++stats_.sent;
  transmit(record);
  return true;
}

bool ConnectionImpl::announce_segments(const Record& record) {
  return std::all_of(record.buffers().begin(), record.buffers().end(),
                     [this](const BufferPtr& buffer) { return is_announced(*buffer); }) ||
         announce_missing_segments(record);
}

bool ConnectionImpl::is_announced(const Buffer& buffer) const {
  return segments_.ledger_of(segment::Segment::of(buffer).id()) != nullptr;
}

// Retires before it announces anything: the record itself may have blocks in a segment that nobody else
// needs.
bool ConnectionImpl::announce_missing_segments(const Record& record) {
  retire_segments();
  for (const BufferPtr& buffer : record.buffers()) {
    if (is_announced(*buffer)) continue;
    const Status announced = announce(segment::Segment::of(*buffer));
    if (announced) continue;
    failure_ = announced.error();
    return false;
  }
  return true;
}

Status ConnectionImpl::announce(segment::Segment& segment) {
  if (segments_.size() >= max_segments) {
    Error error;
    error.what = "offer another segment to a subscriber that already has " + std::to_string(max_segments);
    return error;
  }
  const auto added = segments_.add(segment, weak_from_this());
  if (!added) return added.error();
  Outgoing announcement;
  announcement.kind = PacketKind::segment;
  announcement.segment = added->segment;
  announcement.ledger = added->ledger;
  transmit(std::move(announcement));
  return Success{};
}

void ConnectionImpl::retire_segments() {
  for (const std::uint64_t id : segments_.remove_retired()) {
    Outgoing retirement;
    retirement.kind = PacketKind::retire_segment;
    retirement.segment_id = id;
    transmit(std::move(retirement));
  }
}

// The marks come before the write: once the subscriber can know of a block, the block is its own.
void ConnectionImpl::claim(const RecordPtr& record) {
  Undecided::Entry& entry = undecided_.push(++last_sequence_);
  if (keeps_undelivered_) keep(record, entry);
  for (const BufferPtr& buffer : record->buffers()) {
    const segment::BlockName block = segment::Segment::name_of(*buffer);
    if (segments_.ledger_of(block.segment)->mark(block.slot, block.generation)) entry.claims.push_back(block);
    posix::step("publish: marked");
  }
}

// The usual way: one packet, and the ring takes it, or the socket at once.
void ConnectionImpl::transmit(const RecordPtr& record) {
  const bool in_one_packet = record->size() <= fragment_bytes;
  if (in_one_packet && writes_directly() &&
      (write_into_ring(*record) ||
       is_done(Outbox::write_record(socket_.get(), *record, last_sequence_, traffic_))))
    return;
  Outgoing item;
  item.record = record;
  item.sequence = last_sequence_;
  in_one_packet ? wait_in_line(std::move(item)) : transmit(std::move(item));
}

bool ConnectionImpl::write_into_ring(const Record& record) {
  const RecordPrefix prefix{PacketKind::record, last_sequence_};
  if (!ring_.write(&prefix, sizeof prefix, record.data(), record.size())) return false;
  traffic_.bytes += sizeof prefix + record.size();
  posix::step("publish: written");
  return true;
}

void ConnectionImpl::transmit(Outgoing item) {
  if (writes_directly() && is_done(Outbox::write(socket_.get(), item, traffic_))) return;
  wait_in_line(std::move(item));
}

bool ConnectionImpl::is_done(SendResult written) {
  posix::step("publish: written");
  ring_.sent_packets(traffic_.packets);
  if (written == SendResult::gone) peer_stopped();
  if (written == SendResult::gone || written == SendResult::sent) return true;
  try_again(written);
  return false;
}

void ConnectionImpl::wait_in_line(Outgoing item) {
  outbox_.push(std::move(item));
  if (outbox_.size() > queue_size_ + 2 * max_segments)
    give_up_on_peer();  // it stopped, and segments come and go
}

void ConnectionImpl::flush() {
  if (state_ == State::corked || state_ == State::gone) return;
  const SendResult result = outbox_.flush(socket_.get(), traffic_);
  ring_.sent_packets(traffic_.packets);
  if (result == SendResult::gone) return peer_stopped();
  try_again(result);
  if (result == SendResult::sent && closing_) end_stream();
}

// The socket says when there is room in it again; nobody says when the system has resources again.
void ConnectionImpl::try_again(SendResult result) {
  watch_writable(result == SendResult::full);
  if (result == SendResult::exhausted)
    service_->set_deadline(key_, Service::Clock::now() + pause_when_exhausted);
  else if (result == SendResult::full && closing_)
    service_->set_deadline(key_, linger_ends_);
}

void ConnectionImpl::watch_writable(bool wanted) {
  if (wanted == writable_watched_ || service_ == nullptr) return;
  writable_watched_ = wanted;
  service_->change(socket_.get(), key_, true, wanted);
}

void ConnectionImpl::uncork() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::corked) state_ = State::open;
  const Welcome welcome{PacketKind::welcome, wire_version, first_sequence,
                        static_cast<std::uint32_t>(page_.size()),
                        peer_.reads_ring ? std::uint32_t{reads_ring} : 0};
  const iovec whole{const_cast<Welcome*>(&welcome), sizeof welcome};
  const int page = page_.fd();
  if (posix::send_packet(socket_.get(), &whole, 1, &page, 1) != SendResult::sent) return break_off();
  page_.close_descriptor();
  flush();
}

// Forgets what the subscriber took meanwhile.
void ConnectionImpl::settle() {
  const Verdict verdict = unpack_verdict(page_.verdict().load(std::memory_order_acquire));
  if (is_after(verdict.taken, last_sequence_)) return break_off();  // it can't have taken what was never sent
  while (!undecided_.empty() && !is_after(undecided_.oldest().sequence, verdict.taken))
    drop_oldest_undecided(false);
}

void ConnectionImpl::revoke_oldest_down_to(std::size_t most) {
  if (undecided_.size() <= most) return;
  settle();
  while (undecided_.size() > most && accepts_records()) revoke_through(undecided_.oldest().sequence);
}

void ConnectionImpl::revoke_through(std::uint32_t sequence) {
  std::uint32_t taken = 0;
  const bool won = win_revoke(page_.verdict(), sequence, taken);
  posix::step("publish: revoke decided");
  if (!won && is_after(sequence, taken)) return break_off();  // it keeps changing the word
  while (!undecided_.empty() && !is_after(undecided_.oldest().sequence, sequence))
    drop_oldest_undecided(is_after(undecided_.oldest().sequence, taken));
}

// The subscriber takes nothing more. What it did not take is wanted back, before the marks that keep it go.
void ConnectionImpl::end_deliveries() {
  std::uint32_t taken = 0;
  if (!undecided_.empty()) win_revoke(page_.verdict(), last_sequence_, taken);
  settle();
  while (!undecided_.empty()) {
    const bool comes_back = keeps_undelivered_ && recall(undecided_.oldest());
    drop_oldest_undecided(true);
    if (comes_back) --stats_.dropped;
  }
  outbox_.clear();
}

void ConnectionImpl::keep(const RecordPtr& record, Undecided::Entry& entry) {
  if (record->buffers().empty())
    entry.record = record;
  else
    entry.body.assign(record->data(), record->data() + record->size());
}

bool ConnectionImpl::recall(const Undecided::Entry& entry) {
  if (entry.record) {
    undelivered_.push_back(entry.record);
    return true;
  }
  ParsedBody parsed{};
  parse_body(entry.body.data(), entry.body.size(), parsed);
  std::vector<BufferPtr> buffers;
  for (std::uint32_t i = 0; i < parsed.header.block_count; ++i) {
    buffers.push_back(segments_.revive(parsed.refs[i]));
    if (!buffers.back()) return false;
  }
  undelivered_.push_back(std::make_shared<const Record>(parsed.header, parsed.control, buffers));
  return true;
}

void ConnectionImpl::drop_oldest_undecided(bool revoked) {
  if (revoked) {
    const Undecided::Entry& entry = undecided_.oldest();
    for (const segment::BlockName& block : entry.claims) revoke_mark(block);
    outbox_.drop_record(entry.sequence);
    ++stats_.dropped;
  }
  undecided_.drop_oldest();
}

// Without a ledger nothing needs it: that goes only when it holds no mark, or its peer forged that.
void ConnectionImpl::revoke_mark(const segment::BlockName& block) {
  segment::Ledger* ledger = segments_.ledger_of(block.segment);
  if (ledger != nullptr) ledger->revoke(block.slot, block.generation);
}

void ConnectionImpl::give_up(const segment::BlockName& block) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::gone) return;
  settle();
  const Undecided::Entry* entry = undecided_.find_last(block);
  if (entry != nullptr) revoke_through(entry->sequence);
}

void ConnectionImpl::close() {
  if (posix::forked_since(epoch_)) return;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (!accepts_records()) return;
  state_ = State::draining;
  closing_ = true;
  linger_ends_ = Service::Clock::now() + linger;
  flush();
}

void ConnectionImpl::on_deadline() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::gone) return;
  if (closing_ && Service::Clock::now() >= linger_ends_) outbox_.clear();
  flush();
}

// To the reader the end is one packet more.
void ConnectionImpl::end_stream() {
  posix::stop_sending(socket_.get());
  ring_.sent_packets(++traffic_.packets);
}

// It unsubscribed, or died: its goodbye or its hang-up is on the way to the service thread. Until its hang-up
// it may hold blocks, so the socket, whose end frees them, is not ours to end.
void ConnectionImpl::peer_stopped() {
  state_ = State::draining;
  end_deliveries();
}

// Its reader finds the end of the stream and says goodbye; what it holds stays its own.
void ConnectionImpl::give_up_on_peer() {
  peer_stopped();
  end_stream();
}

// It broke the rules: nothing that it claims to hold counts any more. The service thread sees the hang-up
// that this causes and cleans up there.
void ConnectionImpl::break_off() {
  state_ = State::draining;
  outbox_.clear();
  posix::disconnect(socket_.get());
}

void ConnectionImpl::on_event(const posix::Poller::Event& event) {
  if (event.hung_up) return hung_up();
  if (event.readable) return unsubscribed();  // the only thing that a subscriber ever says
  const std::lock_guard<std::mutex> lock(mutex_);
  flush();
}

// A goodbye, the end of its stream, or something that is not ours to read: in each case nothing more is sent.
void ConnectionImpl::unsubscribed() {
  std::uint8_t byte = 0;
  posix::ReceivedPacket packet;
  const auto result =
      posix::receive_packet(socket_.get(), &byte, sizeof byte, posix::Waiting::return_at_once, false, packet);
  if (result == posix::ReceiveResult::nothing) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    state_ = State::draining;
    end_deliveries();
    if (result == posix::ReceiveResult::closed) service_->change(socket_.get(), key_, false, false);
  }
  if (const auto hub = hub_.lock()) hub->disconnected(shared_from_this());
}

void ConnectionImpl::hung_up() {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == State::gone) return;
    end_deliveries();
    state_ = State::gone;
    segments_.clear();
    service_->remove(socket_.get(), key_);
    socket_.reset();
  }
  if (const auto hub = hub_.lock()) hub->disconnected(shared_from_this());
}

Error ConnectionImpl::last_failure() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return failure_;
}

std::size_t ConnectionImpl::untaken() {
  if (posix::forked_since(epoch_)) return 0;
  const std::lock_guard<std::mutex> lock(mutex_);
  if (accepts_records()) settle();
  return undecided_.size();
}

std::vector<RecordPtr> ConnectionImpl::take_undelivered() {
  const std::lock_guard<std::mutex> lock(mutex_);
  return std::move(undelivered_);
}

ConnectionStats ConnectionImpl::stats() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  ConnectionStats stats = stats_;
  stats.bytes = traffic_.bytes;
  stats.queued = outbox_.records();
  stats.in_flight = undecided_.size();
  return stats;
}

}  // namespace channel
}  // namespace tzc

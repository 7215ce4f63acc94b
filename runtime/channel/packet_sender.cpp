// SPDX-License-Identifier: BSD-3-Clause
#include "channel/packet_sender.h"

#include <utility>

#include "posix/socket.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

using posix::SendResult;

constexpr std::chrono::milliseconds pause_before_sending_again{20};

}  // namespace

PacketSender::PacketSender(posix::FileDescriptor socket, RingWriter ring, std::size_t most_waiting)
    : socket_(std::move(socket)), ring_(std::move(ring)), most_waiting_(most_waiting) {}

void PacketSender::watched_by(Service& service, std::uint64_t key) {
  service_ = &service;
  key_ = key;
}

// The hot path: one packet, and the ring takes it, or the socket at once.
PacketSender::Result PacketSender::send(const RecordPtr& record, std::uint32_t sequence) {
  const bool in_one_packet = record->size() <= fragment_bytes;
  Result result = Result::accepted;
  if (in_one_packet && !corked_ && outbox_.empty() &&
      (write_into_ring(*record, sequence) ||
       is_done(Outbox::write_record(socket(), *record, sequence, traffic_), result)))
    return result;
  Outgoing item;
  item.record = record;
  item.sequence = sequence;
  return in_one_packet ? enqueue(std::move(item)) : send(std::move(item));
}

bool PacketSender::write_into_ring(const Record& record, std::uint32_t sequence) {
  const RecordPrefix prefix{PacketKind::record, sequence};
  if (!ring_.write(&prefix, sizeof prefix, record.data(), record.size())) return false;
  traffic_.bytes += sizeof prefix + record.size();
  sync_point("publish: written");
  return true;
}

PacketSender::Result PacketSender::send(Outgoing item) {
  Result result = Result::accepted;
  if (!corked_ && outbox_.empty() && is_done(Outbox::write(socket(), item, traffic_), result)) return result;
  return enqueue(std::move(item));
}

bool PacketSender::is_done(SendResult written, Result& result) {
  sync_point("publish: written");
  ring_.sent_packets(traffic_.packets);
  if (written == SendResult::gone) result = Result::gone;
  if (written == SendResult::gone || written == SendResult::sent) return true;
  try_again(written);
  return false;
}

PacketSender::Result PacketSender::enqueue(Outgoing item) {
  outbox_.push(std::move(item));
  return outbox_.size() > most_waiting_ ? Result::too_slow : Result::accepted;
}

PacketSender::Result PacketSender::uncork() {
  corked_ = false;
  return flush();
}

PacketSender::Result PacketSender::flush() {
  if (corked_) return Result::accepted;
  if (ending_ && Service::Clock::now() >= deadline_) outbox_.clear();
  const SendResult result = outbox_.flush(socket(), traffic_);
  ring_.sent_packets(traffic_.packets);
  if (result == SendResult::gone) return Result::gone;
  try_again(result);
  if (result == SendResult::sent && ending_) end_stream();
  return Result::accepted;
}

PacketSender::Result PacketSender::end_by(Service::Clock::time_point deadline) {
  ending_ = true;
  deadline_ = deadline;
  return flush();
}

// The reader counts the end of the stream as one more packet.
void PacketSender::end_stream() {
  ending_ = false;
  posix::stop_sending(socket());
  ring_.sent_packets(++traffic_.packets);
}

// The socket reports when it takes packets again; the system does not report when it has resources again.
void PacketSender::try_again(SendResult result) {
  if (service_ == nullptr) return;
  const bool full = result == SendResult::full;
  if (full != writable_watched_) service_->change(socket(), key_, true, full);
  writable_watched_ = full;
  if (result == SendResult::exhausted)
    service_->set_deadline(key_, Service::Clock::now() + pause_before_sending_again);
  else if (full && ending_)
    service_->set_deadline(key_, deadline_);
}

void PacketSender::drop_records_through(std::uint32_t sequence) {
  outbox_.drop_records_through(sequence);
}

void PacketSender::stop_reading() {
  service_->change(socket(), key_, false, false);
}

void PacketSender::close() {
  service_->remove(socket(), key_);
  socket_.reset();
}

}  // namespace channel
}  // namespace tzc

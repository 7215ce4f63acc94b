// SPDX-License-Identifier: BSD-3-Clause
#include "channel/publish/packet_sender.h"

#include <algorithm>
#include <utility>

#include "sync_point/sync_point.h"

namespace tzc {
namespace channel {
namespace {

using posix::SendResult;

constexpr std::chrono::milliseconds pause_before_sending_again{20};
constexpr std::chrono::milliseconds longest_patience{500};

}  // namespace

PacketSender::PacketSender(SendingSocket socket, RingWriter ring, std::size_t most_waiting)
    : socket_(std::move(socket)), ring_(std::move(ring)), most_waiting_(most_waiting) {}

// The hot path: one packet, and the ring takes it, or the socket at once.
PacketSender::Result PacketSender::send(const RecordPtr& record, std::uint32_t sequence) {
  const bool in_one_packet = record->size() <= fragment_bytes;
  Result result = Result::accepted;
  if (in_one_packet && !corked_ && outbox_.empty() &&
      (write_into_ring(*record, sequence) || is_done(through_socket([&](int socket) {
                                                       return Outbox::write_record(socket, *record, sequence,
                                                                                   traffic_);
                                                     }),
                                                     result)))
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
  const auto write = [&](int socket) { return Outbox::write(socket, item, traffic_); };
  if (!corked_ && outbox_.empty() && is_done(through_socket(write), result)) return result;
  return enqueue(std::move(item));
}

template <class Write>
SendResult PacketSender::through_socket(Write write) {
  const int socket = socket_.open();
  return socket < 0 ? SendResult::exhausted : write(socket);
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
  SendResult result = SendResult::sent;
  if (!outbox_.empty()) result = through_socket([&](int socket) { return outbox_.flush(socket, traffic_); });
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

void PacketSender::end_stream() {
  ending_ = false;
  if (socket_.end()) ring_.sent_packets(++traffic_.packets);
}

// The socket reports when it takes packets again, and when there is one again; the system does not report when it has
// resources again.
void PacketSender::try_again(SendResult result) {
  socket_.watch_writable(result == SendResult::full);
  if (result == SendResult::exhausted && (socket_.get() >= 0 || ending_))
    socket_.call_at(Service::Clock::now() + pause_before_sending_again);
  else if (result == SendResult::full && ending_)
    socket_.call_at(deadline_);
}

void PacketSender::rest() {
  if (!socket_.is_loan() || socket_.get() < 0 || corked_ || ending_ || !outbox_.empty()) return;
  const bool rests = packets_at_rest_ == traffic_.packets;
  if ((rests || socket_.is_wanted()) && ring_.all_packets_read()) {
    socket_.give_up();
    ring_.sent_packets(++traffic_.packets);
    return;
  }
  packets_at_rest_ = traffic_.packets;
  patience_ = rests ? std::min(2 * patience_, longest_patience) : socket_.patience();
  socket_.call_at(Service::Clock::now() + patience_);
}

void PacketSender::drop_records_through(std::uint32_t sequence) {
  outbox_.drop_records_through(sequence);
}

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/shared_link.h"

#include <ros/connection.h>
#include <ros/publication.h>

#include <utility>
#include <vector>

#include "roscpp/publish/parked_link.h"
#include "roscpp/publish/process_end.h"
#include "roscpp/throttled_warning.h"
#include "roscpp/upgrade/offer.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {

namespace {

/// For how long nothing is lost of what waits for a subscriber that is slower than the publisher. Afterwards it
/// loses what it would lose without a move: otherwise it would see old messages for ever.
constexpr std::chrono::seconds patience{1};

constexpr int most_at_a_time = 8;

}  // namespace

SharedLink::SharedLink(std::shared_ptr<PublicationStream> stream, const ros::PublicationPtr& publication,
                       ros::TransportSubscriberLinkPtr parked, channel::ConnectionPtr connection,
                       std::size_t queued)
    : stream_(std::move(stream)),
      parked_(std::move(parked)),
      connection_(std::move(connection)),
      queued_for_tcpros_(queued),
      waiting_(publication->getMaxQueue()) {
  parent_ = publication;
  topic_ = parked_->getTopic();
  destination_caller_id_ = parked_->getDestinationCallerID();
  connection_id_ = parked_->getConnectionID();
  stream_->records().subscribers().add(*connection_, destination_caller_id_);
}

SharedLink::~SharedLink() {
  parked_->getConnection()->removeDropListener(drop_listener_);
  stream_->records().subscribers().remove(*connection_);
  connection_->close();
}

// The function has one pointer, which boost::function has room for: with more it would allocate them, twice for each connection.
void SharedLink::tell_of_end(std::weak_ptr<LinkEndListener> listener) {
  end_listener_ = std::move(listener);
  const auto dropped = [weak = boost::weak_ptr<SharedLink>(boost::static_pointer_cast<SharedLink>(
                            shared_from_this()))](const ros::ConnectionPtr&, ros::Connection::DropReason) {
    const SharedLinkPtr link = weak.lock();
    const std::shared_ptr<LinkEndListener> listening = link ? link->end_listener_.lock() : nullptr;
    if (listening) listening->ended(link);
  };
  drop_listener_ = parked_->getConnection()->addDropListener(dropped);
}

void SharedLink::drop() {
  parked_->drop();
}

std::string SharedLink::getTransportInfo() {
  return "TZC shared memory, beside a parked " + parked_->getTransportInfo();
}

void SharedLink::getPublishTypes(bool& ser, bool& nocopy, const std::type_info& type) {
  nocopy = stream_->records().codecs().has(type) && !has_returned() && !stream_->would_overtake();
  ser = !nocopy;
}

void SharedLink::enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) {
  if (!ser)
    publish_by_pointer(message);
  else if (nocopy)
    publish_alone(message);
  else if (!take_bytes(message))
    pass_to_tcpros(message);
}

void SharedLink::publish_by_pointer(const ros::SerializedMessage& message) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == State::returned) return;  // it needs bytes, and roscpp will pass them
  }
  if (!stream_->records().codecs().has(*message.type_info)) return;
  // Without an exception in any case: roscpp is going to queue the message, and counts its number there.
  stream_->records().unless_out_of_memory([&] {
    if (!stream_->leaves_to_bytes(message)) deliver(stream_->of_pointer(message));
    return OutgoingMessage();
  });
}

bool SharedLink::take_bytes(const ros::SerializedMessage& message) {
  stream_->saw_serialized(message);
  const bool went_by_pointer = stream_->went_by_pointer(message);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (belongs_to_tcpros(went_by_pointer)) return false;
    if (state_ == State::returned) return true;
  }
  if (!went_by_pointer) deliver(stream_->of_bytes(message));
  return true;
}

// The link must not look drained before TCPROS has the message.
void SharedLink::pass_to_tcpros(const ros::SerializedMessage& message) {
  parked_->enqueueMessage(message, true, false);
  const std::lock_guard<std::mutex> lock(mutex_);
  if (queued_for_tcpros_ > 0) --queued_for_tcpros_;
}

void SharedLink::publish_alone(const ros::SerializedMessage& message) {
  if (has_returned()) return parked_->enqueueMessage(message, true, true);
  deliver(stream_->of_bytes_alone(message));
}

bool SharedLink::belongs_to_tcpros(bool went_by_pointer) {
  if (queued_for_tcpros_ > 0) return true;
  if (state_ != State::returned) return false;
  if (queued_at_return_ == 0) return true;
  --queued_at_return_;
  return !went_by_pointer;
}

void SharedLink::deliver(const OutgoingMessage& message) {
  if (!message.record) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ != State::live || !send(message.record)) waiting_.push(message.record);
  }
  stats_.messages_sent_++;
  stats_.bytes_sent_ += message.bytes;
  stats_.message_data_sent_ += message.bytes;
  stream_->records().count_sent(message);
}

bool SharedLink::send(const channel::RecordPtr& record) {
  if (connection_->send(record)) return true;
  break_off();
  if (!connection_->alive()) return false;  // the channel's own thread handles the end
  const Error failure = connection_->last_failure();
  TZC_WARN_THROTTLED_FOR(
      subject_of(failure.code, topic_ + " to " + destination_caller_id_), 10,
      "TZC: " << topic_ << " to " << destination_caller_id_ << " goes back to TCPROS: " << failure.text());
  connection_->close();
  return false;
}

SharedLink::Progress SharedLink::try_go_live() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ != State::draining) return Progress::finished;
  if (!switched_) {
    if (queued_for_tcpros_ > 0 || !is_drained(*parked_)) return Progress::none;
    const std::uint64_t most_bytes = stream_->most_held_bytes();
    switched_ = connection_->send(channel::make_record(kSwitch, &most_bytes, sizeof(most_bytes), {}));
    begin_patience();
  }
  const bool some = send_what_waits();
  if (state_ != State::draining) return Progress::finished;
  return some ? Progress::some : Progress::none;
}

// Not all at once: the channel would revoke what exceeds the queue. TCPROS keeps the excess in its sockets.
bool SharedLink::send_what_waits() {
  bool some = false;
  for (; !waiting_.empty(); waiting_.pop(), some = true) {
    if (is_patient() && waiting_.queue_size() != 0 && connection_->in_flight() >= waiting_.queue_size())
      return some;
    if (!send(waiting_.front())) return some;
  }
  state_ = State::live;
  sync_point("move: live");
  return some;
}

void SharedLink::begin_patience() {
  patient_until_ = Clock::now() + patience;
}

bool SharedLink::is_patient() const {
  return Clock::now() < patient_until_;
}

void SharedLink::break_off() {
  if (state_ != State::broken) patient_until_ = Clock::time_point();
  state_ = State::broken;
}

void SharedLink::collect_undelivered() {
  break_off();
  waiting_.push_before(connection_->take_undelivered());
}

// Some at a time: where more is published meanwhile than is serialized here, there is no last one, and the caller's thread has other links.
SharedLink::Progress SharedLink::hand_back() {
  int handed = 0;
  for (; handed < most_at_a_time; ++handed) {
    const channel::RecordPtr record = next_to_hand_back();
    if (!record) break;
    const ros::SerializedMessage message = stream_->records().to_stock_bytes(record);
    sync_point("return: serialized");
    if (drop_waiting(record) && message.buf) parked_->enqueueMessage(message, true, false);
  }
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.empty() && queued_for_tcpros_ == 0) return Progress::finished;
  return handed > 0 ? Progress::some : Progress::none;
}

// What was in flight to a dead process need not be serialized: its TCPROS connection ends in a moment. The kernel may
// close that connection after the channel's socket, so the process itself is asked for, too.
channel::RecordPtr SharedLink::next_to_hand_back() {
  if (peer_is_gone(*parked_) || has_ended(connection_->peer().pid)) return nullptr;
  const std::lock_guard<std::mutex> lock(mutex_);
  collect_undelivered();
  if (queued_for_tcpros_ > 0) return nullptr;
  if (patient_until_ == Clock::time_point()) begin_patience();
  if (!is_patient()) waiting_.keep_newest();
  const bool ready = !waiting_.empty() && (!is_patient() || has_room(*parked_, waiting_.queue_size()));
  return ready ? waiting_.front() : nullptr;
}

/// False: it was dropped as the oldest while it was serialized.
bool SharedLink::drop_waiting(const channel::RecordPtr& record) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (waiting_.empty() || waiting_.front() != record) return false;
  waiting_.pop();
  return true;
}

bool SharedLink::try_return(std::size_t queued) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::returned) return true;
  collect_undelivered();
  if (queued_for_tcpros_ > 0 || !waiting_.empty()) return false;
  queued_at_return_ = queued;
  state_ = State::returned;
  return true;
}

bool SharedLink::may_be_replaced() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::returned && queued_at_return_ == 0;
}

bool SharedLink::has_returned() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::returned;
}

}  // namespace detail
}  // namespace tzc

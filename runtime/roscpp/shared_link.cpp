// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/shared_link.h"

#include <linux/sockios.h>
#include <ros/connection.h>
#include <ros/console.h>
#include <ros/publication.h>
#include <sys/ioctl.h>

#include "roscpp/offer.h"
#include "roscpp/port.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/wire_form.h"

namespace tzc {

namespace access = roscpp_access;

namespace {

/// What waits beside the queue, as a TCPROS connection's socket buffers would hold it.
constexpr std::size_t kBufferedBytes = 4 << 20;

}  // namespace

SharedLink::SharedLink(std::shared_ptr<detail::Port> port, const ros::PublicationPtr& publication,
                       ros::TransportSubscriberLinkPtr parked, channel::ConnectionPtr connection,
                       std::size_t queued)
    : port_(std::move(port)),
      parked_(std::move(parked)),
      connection_(std::move(connection)),
      queue_size_(publication->getMaxQueue()),
      queued_for_tcpros_(queued) {
  parent_ = publication;
  topic_ = parked_->getTopic();
  destination_caller_id_ = parked_->getDestinationCallerID();
  connection_id_ = parked_->getConnectionID();
}

SharedLink::~SharedLink() {
  parked_->getConnection()->removeDropListener(drop_listener_);
  connection_->close();
}

void SharedLink::on_end(std::function<void()> ended) {
  drop_listener_ = parked_->getConnection()->addDropListener(
      [ended = std::move(ended)](const ros::ConnectionPtr&, ros::Connection::DropReason) { ended(); });
}

void SharedLink::drop() {
  parked_->drop();
}

std::string SharedLink::getTransportInfo() {
  return "TZC shared memory, beside a parked " + parked_->getTransportInfo();
}

void SharedLink::getPublishTypes(bool& ser, bool& nocopy, const std::type_info& type) {
  const std::lock_guard<std::mutex> lock(mutex_);
  nocopy = state_ != State::returned && port_->records().knows(type);
  ser = !nocopy;
}

void SharedLink::enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) {
  if (!ser)
    publish_by_pointer(message);
  else if (!nocopy)
    publish_bytes(message);
  else
    publish_alone(message);
}

void SharedLink::publish_by_pointer(const ros::SerializedMessage& message) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == State::returned) return;  // it asked for bytes, and will get them
  }
  if (port_->records().knows(*message.type_info)) deliver(port_->pointer_record(message));
}

void SharedLink::publish_bytes(const ros::SerializedMessage& message) {
  port_->saw_serialized(message);
  const bool went_by_pointer = message.type_info && port_->records().knows(*message.type_info);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (goes_to_tcpros(went_by_pointer)) return parked_->enqueueMessage(message, true, false);
    if (state_ == State::returned) return;
  }
  if (!went_by_pointer) deliver(port_->bytes_record(message));
}

void SharedLink::publish_alone(const ros::SerializedMessage& message) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ == State::returned) return parked_->enqueueMessage(message, true, true);
  }
  deliver(port_->bytes_record(message, 1));
}

bool SharedLink::goes_to_tcpros(bool went_by_pointer) {
  if (queued_for_tcpros_ > 0) {
    --queued_for_tcpros_;
    return true;
  }
  if (state_ != State::returned) return false;
  if (queued_at_return_ == 0) return true;
  --queued_at_return_;
  return !went_by_pointer;
}

void SharedLink::deliver(const Shipment& shipment) {
  if (!shipment.record) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (state_ != State::live || !send(shipment.record)) wait_in_line(shipment.record);
  }
  stats_.messages_sent_++;
  stats_.bytes_sent_ += shipment.bytes;
  stats_.message_data_sent_ += shipment.bytes;
  port_->records().count_sent(shipment);
}

bool SharedLink::send(const channel::RecordPtr& record) {
  if (connection_->send(record)) return true;
  state_ = State::broken;
  if (!connection_->alive()) return false;  // the channel's own thread sees to it
  ROS_WARN_STREAM_THROTTLE(10, "TZC: " << topic_ << " to " << destination_caller_id_
                                       << " goes back to TCPROS: " << connection_->last_failure().text());
  connection_->close();
  return false;
}

void SharedLink::wait_in_line(const channel::RecordPtr& record) {
  waiting_.push_back(record);
  waiting_bytes_ += size_of(record);
  while (queue_size_ != 0 && waiting_.size() > queue_size_ && waiting_bytes_ > kBufferedBytes) {
    waiting_bytes_ -= size_of(waiting_.front());
    waiting_.pop_front();
  }
}

bool SharedLink::tcpros_drained() const {
  {
    const boost::mutex::scoped_lock lock(access::outbox_mutex_(*parked_));
    const bool idle = access::outbox_(*parked_).empty() && !access::writing_message_(*parked_);
    if (!idle || !access::header_written_(*parked_)) return false;
  }
  const auto tcp = boost::dynamic_pointer_cast<ros::TransportTCP>(parked_->getConnection()->getTransport());
  int unacknowledged = 0;
  return !tcp || ioctl(access::sock_(*tcp), SIOCOUTQ, &unacknowledged) != 0 || unacknowledged == 0;
}

bool SharedLink::try_go_live() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ != State::draining) return true;
  if (!switched_) {
    if (queued_for_tcpros_ > 0 || !tcpros_drained()) return false;
    switched_ = connection_->send(channel::make_record(kSwitch, nullptr, 0, {}));
  }
  send_what_waits();
  return state_ != State::draining;
}

// Not at once, for the channel would revoke what goes beyond the queue; TCPROS had room for it in its
// sockets.
void SharedLink::send_what_waits() {
  while (!waiting_.empty() && (queue_size_ == 0 || connection_->untaken() < queue_size_)) {
    if (!send(waiting_.front())) return;
    waiting_bytes_ -= size_of(waiting_.front());
    waiting_.pop_front();
  }
  if (waiting_.empty()) state_ = State::live;
}

bool SharedLink::try_return(std::size_t queued) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (state_ == State::returned) return true;
  state_ = State::broken;
  const std::vector<channel::RecordPtr> undelivered = connection_->take_undelivered();
  waiting_.insert(waiting_.begin(), undelivered.begin(), undelivered.end());
  for (const channel::RecordPtr& record : undelivered) waiting_bytes_ += size_of(record);
  if (queued_for_tcpros_ > 0) return false;
  for (; !waiting_.empty() && tcpros_has_room(); waiting_.pop_front()) give_to_tcpros(waiting_.front());
  if (!waiting_.empty()) return false;
  queued_at_return_ = queued;
  state_ = State::returned;
  return true;
}

bool SharedLink::tcpros_has_room() const {
  const boost::mutex::scoped_lock lock(access::outbox_mutex_(*parked_));
  return queue_size_ == 0 || access::outbox_(*parked_).size() < queue_size_;
}

bool SharedLink::may_be_replaced() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::returned && queued_at_return_ == 0;
}

bool SharedLink::has_returned() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return state_ == State::returned;
}

void SharedLink::give_to_tcpros(const channel::RecordPtr& record) {
  waiting_bytes_ -= size_of(record);
  const ros::SerializedMessage message = port_->records().wire_form(record);
  if (message.buf) parked_->enqueueMessage(message, true, false);
}

}  // namespace tzc

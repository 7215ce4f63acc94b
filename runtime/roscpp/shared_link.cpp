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

namespace tzc {

namespace access = roscpp_access;

SharedLink::SharedLink(std::weak_ptr<detail::Port> port, const ros::PublicationPtr& publication,
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
  const std::shared_ptr<detail::Port> port = port_.lock();
  nocopy = port && port->records().knows(type);
  ser = !nocopy;
}

void SharedLink::enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) {
  if (!ser)
    publish_by_pointer(message);
  else if (!nocopy)
    publish_bytes(message);
  else if (const std::shared_ptr<detail::Port> port = port_.lock())
    deliver(port->bytes_record(message, 1));
}

void SharedLink::publish_by_pointer(const ros::SerializedMessage& message) {
  const std::shared_ptr<detail::Port> port = port_.lock();
  if (port && port->records().knows(*message.type_info)) deliver(port->pointer_record(message));
}

void SharedLink::publish_bytes(const ros::SerializedMessage& message) {
  const std::shared_ptr<detail::Port> port = port_.lock();
  if (port) port->saw_serialized(message);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (queued_for_tcpros_ > 0) {
      --queued_for_tcpros_;
      return parked_->enqueueMessage(message, true, false);
    }
  }
  if (!port) return;
  const bool went_by_pointer = message.type_info && port->records().knows(*message.type_info);
  if (!went_by_pointer) deliver(port->bytes_record(message));
}

void SharedLink::deliver(const Shipment& shipment) {
  if (!shipment.record) return;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (live_)
      send(shipment.record);
    else
      wait_in_line(shipment.record);
  }
  stats_.messages_sent_++;
  stats_.bytes_sent_ += shipment.bytes;
  stats_.message_data_sent_ += shipment.bytes;
  if (const std::shared_ptr<detail::Port> port = port_.lock()) port->records().count_sent(shipment);
}

void SharedLink::send(const channel::RecordPtr& record) {
  if (connection_->send(record) || !connection_->alive()) return;  // the channel's own thread takes a dead one away
  ROS_WARN_STREAM_THROTTLE(10, "TZC: " << topic_ << " to " << destination_caller_id_ << " goes back to TCPROS: "
                                       << connection_->last_failure().text());
  connection_->close();
}

void SharedLink::wait_in_line(const channel::RecordPtr& record) {
  if (queue_size_ != 0 && waiting_.size() >= queue_size_) waiting_.pop_front();
  waiting_.push_back(record);
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
  if (live_) return true;
  if (queued_for_tcpros_ > 0 || !tcpros_drained()) return false;
  connection_->send(channel::make_record(kSwitch, nullptr, 0, {}));
  for (const channel::RecordPtr& record : waiting_) send(record);
  waiting_.clear();
  live_ = true;
  return true;
}

}  // namespace tzc

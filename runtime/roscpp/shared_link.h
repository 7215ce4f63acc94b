// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscriber_link.h>
#include <ros/transport_subscriber_link.h>
#include <tzc/channel.h>

#include <boost/signals2/connection.hpp>
#include <deque>
#include <memory>
#include <mutex>

#include "roscpp/record_maker.h"

namespace tzc {
namespace detail {
class Port;
}

/// A subscriber that takes its messages through shared memory: stands in Publication::subscriber_links_ where
/// its TCPROS link stood, which it keeps parked. roscpp takes it for an intraprocess link, because only those
/// are given messages by pointer.
///
/// Life: draining (messages that were queued for TCPROS go there, newer ones wait here) -> live -> ended (the
/// TCPROS link was dropped) or fallen back (the channel broke; the Port puts the TCPROS link back).
class SharedLink : public ros::SubscriberLink {
 public:
  /// @param queued messages in Publication::publish_queue_ that belong to the TCPROS link; the caller holds
  /// the
  ///        publication's locks
  SharedLink(std::weak_ptr<detail::Port> port, const ros::PublicationPtr& publication,
             ros::TransportSubscriberLinkPtr parked, channel::ConnectionPtr connection, std::size_t queued);
  ~SharedLink() override;

  /// \name ros::SubscriberLink
  /// @{
  /// roscpp's three ways: (ser, nocopy) = (0,1) publish by pointer; (1,0) the poll thread, with bytes; (1,1)
  /// bytes for this subscriber alone (SingleSubscriberPublisher). Never blocks.
  void enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) override;
  void drop() override;
  std::string getTransportType() override { return "TZC"; }
  std::string getTransportInfo() override;
  bool isIntraprocess() override { return true; }
  void getPublishTypes(bool& ser, bool& nocopy, const std::type_info& type) override;
  /// @}

  /// Sends, or keeps while draining. Under subscriber_links_mutex_; never blocks.
  void deliver(const Shipment& shipment);

  /// Starts sending if everything that was given to TCPROS has left it. False: not yet, ask again. Worker
  /// thread.
  bool try_go_live();

  /// Calls `ended` once, when the TCPROS link is dropped (the subscriber or the publisher ended the
  /// connection).
  void on_end(std::function<void()> ended);

  const ros::TransportSubscriberLinkPtr& parked() const { return parked_; }
  const channel::ConnectionPtr& connection() const { return connection_; }

 private:
  void publish_by_pointer(const ros::SerializedMessage& message);
  void publish_bytes(const ros::SerializedMessage& message);
  /// Under mutex_. A subscriber that can't be given the record's memory goes back to TCPROS.
  void send(const channel::RecordPtr& record);
  void wait_in_line(const channel::RecordPtr& record);
  bool tcpros_drained() const;

  const std::weak_ptr<detail::Port> port_;
  const ros::TransportSubscriberLinkPtr parked_;
  const channel::ConnectionPtr connection_;
  const std::size_t queue_size_;
  boost::signals2::connection drop_listener_;

  std::mutex mutex_;  ///< guards what follows; innermost, but for the channel's own locks
  std::size_t queued_for_tcpros_;
  bool live_ = false;
  std::deque<channel::RecordPtr> waiting_;
};
typedef boost::shared_ptr<SharedLink> SharedLinkPtr;

}  // namespace tzc

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
///   draining   what was queued for TCPROS goes there, what is newer waits here
///      v
///   live       straight into the channel
///      v       the channel breaks
///   broken     what is published waits here
///      v       the subscriber has handed over all that it took
///   returned   what it did not take goes over TCPROS, then what waited here, then what comes; the Port puts
///              the TCPROS link back
///
/// From each of them the link may end with its TCPROS link.
class SharedLink : public ros::SubscriberLink {
 public:
  /// @param queued messages in Publication::publish_queue_ that belong to the TCPROS link; the caller holds
  /// the
  ///        publication's locks
  SharedLink(std::shared_ptr<detail::Port> port, const ros::PublicationPtr& publication,
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

  /// Starts sending if everything that was given to TCPROS has left it, as fast as the subscriber takes it.
  /// False: not done yet, ask again.
  bool try_go_live();

  /// The channel has broken and the subscriber has handed over all that it took of it: everything else goes
  /// over TCPROS from here on, as fast as it takes it. The caller holds the publication's locks. False: not
  /// done yet, ask again.
  /// @param queued messages in Publication::publish_queue_
  bool try_return(std::size_t queued);
  /// Returned, and of the messages that it was given by pointer none waits in roscpp's queue any more: the
  /// TCPROS link can take its place.
  bool may_be_replaced() const;
  bool has_returned() const;

  /// Calls `ended` once, when the TCPROS link is dropped (the subscriber or the publisher ended the
  /// connection).
  void on_end(std::function<void()> ended);

  const ros::TransportSubscriberLinkPtr& parked() const { return parked_; }
  const channel::ConnectionPtr& connection() const { return connection_; }

 private:
  void publish_by_pointer(const ros::SerializedMessage& message);
  void publish_bytes(const ros::SerializedMessage& message);
  void publish_alone(const ros::SerializedMessage& message);
  enum class State { draining, live, broken, returned };

  /// \name Under mutex_
  /// @{
  /// False: the channel does not take it, nor anything after it.
  bool send(const channel::RecordPtr& record);
  void send_what_waits();
  void wait_in_line(const channel::RecordPtr& record);
  void give_to_tcpros(const channel::RecordPtr& record);
  bool goes_to_tcpros(bool went_by_pointer);
  /// @}
  bool tcpros_drained() const;
  bool tcpros_has_room() const;

  const std::shared_ptr<detail::Port> port_;  ///< lives as long as somebody is on shared memory
  const ros::TransportSubscriberLinkPtr parked_;
  const channel::ConnectionPtr connection_;
  const std::size_t queue_size_;
  boost::signals2::connection drop_listener_;

  mutable std::mutex
      mutex_;  ///< guards what follows; innermost, but for the channel's and the TCPROS link's own
  State state_ = State::draining;
  bool switched_ = false;          ///< the subscriber was told that shared records follow
  std::size_t queued_for_tcpros_;  ///< draining: messages of roscpp's queue that belong to TCPROS
  std::size_t queued_at_return_ =
      0;  ///< returned: messages of roscpp's queue that may have gone by pointer already
  std::deque<channel::RecordPtr> waiting_;
  std::size_t waiting_bytes_ = 0;
};
typedef boost::shared_ptr<SharedLink> SharedLinkPtr;

}  // namespace tzc

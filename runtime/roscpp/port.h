// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/single_subscriber_publisher.h>
#include <ros/transport_subscriber_link.h>
#include <tzc/channel.h>
#include <tzc/options.h>

#include <atomic>
#include <deque>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "roscpp/offering.h"
#include "roscpp/record_maker.h"
#include "roscpp/shared_link.h"
#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// The shared-memory side of one publication of this process:
///
///   connect callback -> offer (XMLRPC) -> the subscriber connects to the channel -> its TCPROS link is
///   parked and a SharedLink stands in its place -> the channel breaks: the TCPROS link is put back, and
///                                  offered again after a while
///                                  -> the TCPROS link is dropped: the SharedLink goes, and the user's
///                                  callbacks hear it
///
/// Thread-safe. Locks, outermost first: roscpp's advertised_topics_mutex_, publish_queue_mutex_,
/// subscriber_links_mutex_; the link's; the channel's. The worker moves links, and may wait for those locks
/// while somebody publishes; the channel's thread must not.
class Port : public std::enable_shared_from_this<Port> {
 public:
  /// The port of a publication, made with the first attachment and shared by all of the process.
  static std::shared_ptr<Port> of(const ros::PublicationPtr& publication, const PublisherOptions& options,
                                  Worker& worker, Worker& caller);
  ~Port();

  const std::shared_ptr<MemorySource>& memory() const { return memory_; }
  OnExhausted on_exhausted() const { return on_exhausted_; }
  RecordMaker& records() { return records_; }
  PublisherStatistics statistics() const;
  bool wants_pointer(const std::type_info& type) const;

  /// Sends an encoded message of a known type to all subscribers, past roscpp's own publish: no view is built
  /// for nobody to see. False, and nothing happened, unless every link of the publication is a SharedLink and
  /// nothing waits in its queue.
  bool publish_directly(const std::type_info& type, message::Encoded& encoded);

  /// roscpp's connect callback, on the caller's thread: offers shared memory to the subscriber.
  void on_connect(const ros::SingleSubscriberPublisher& subscriber);
  /// A subscriber by that name says that it can take an offer. On the caller's thread.
  void offer_again(const std::string& caller_id);

  /// \name For SharedLink, under subscriber_links_mutex_
  /// @{
  Shipment pointer_record(const ros::SerializedMessage& message);
  Shipment bytes_record(const ros::SerializedMessage& message) { return records_.of_bytes(message, links_); }
  Shipment bytes_record(const ros::SerializedMessage& message, std::size_t links) {
    return records_.of_bytes(message, links);
  }
  void saw_serialized(const ros::SerializedMessage& message);
  /// @}

 private:
  using TcpLink = ros::TransportSubscriberLinkPtr;

  Port(const ros::PublicationPtr& publication, std::shared_ptr<SegmentMemory> memory,
       OnExhausted on_exhausted, Worker& worker, Worker& caller);
  bool listen(std::size_t queue_size);
  std::uint32_t take_sequence(const ros::SerializedMessage& message);
  void count_numbered();
  void track_queue(const std::vector<ros::SerializedMessage>& queue);
  void forget_queue();

  bool authorizes(const channel::Credentials& peer, const std::string& token);
  void connected(const channel::ConnectionPtr& connection);
  void disconnected(const channel::ConnectionPtr& connection);
  void watch(const SharedLinkPtr& link);
  SharedLinkPtr park(const TcpLink& tcp, const channel::ConnectionPtr& connection);
  void go_live(const SharedLinkPtr& link);
  void come_back(const SharedLinkPtr& link);
  bool try_come_back(ros::Publication& publication, const SharedLinkPtr& link);
  void put_back_locked(ros::Publication& publication, const SharedLinkPtr& link);
  void ended(const SharedLinkPtr& link);
  void look_again(const SharedLinkPtr& link, void (Port::*act)(const SharedLinkPtr&));

  const ros::PublicationWPtr publication_;
  const std::string topic_;
  const std::shared_ptr<SegmentMemory> segments_;
  const std::shared_ptr<MemorySource> memory_;
  const OnExhausted on_exhausted_;
  Worker& worker_;
  RecordMaker records_;
  const std::shared_ptr<Offering> offering_;
  std::shared_ptr<channel::Publisher> channel_;

  /// \name Changed under subscriber_links_mutex_
  /// @{
  std::atomic<std::size_t> links_{0};   ///< SharedLinks that take what is published
  std::size_t standing_ = 0;            ///< all in the publication, also those that have returned to TCPROS
  std::deque<const void*> unnumbered_;  ///< messages in roscpp's queue, which it has yet to number
  /// @}

  std::map<channel::ConnectionPtr, boost::weak_ptr<SharedLink>> by_connection_;  ///< worker's thread
};

/// The port of a topic that this process advertises; null when there is none.
std::shared_ptr<Port> find_port(const std::string& topic);

}  // namespace detail
}  // namespace tzc

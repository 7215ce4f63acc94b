// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/single_subscriber_publisher.h>
#include <ros/transport_subscriber_link.h>
#include <tzc/channel.h>
#include <tzc/detail/attachment.h>
#include <tzc/options.h>

#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "roscpp/publish/endpoint_statistics.h"
#include "roscpp/publish/link_migration.h"
#include "roscpp/publish/local_callbacks.h"
#include "roscpp/publish/publication_stream.h"
#include "roscpp/upgrade/upgrade_negotiator.h"
#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// The shared-memory side of one publication of this process: its memory, its channel, and the invited
/// subscribers.
///
///   connect callback -> offer (UpgradeNegotiator) -> the subscriber connects to the channel -> LinkMigration
///   publish -> SharedLink -> PublicationStream: one record for all links -> channel
///
/// Thread-safe. Locks, outermost first: roscpp's advertised_topics_mutex_, publish_queue_mutex_,
/// subscriber_links_mutex_; the link's; the channel's. The worker moves links, and may wait for those locks
/// while another thread publishes; the channel's thread must not.
class PublicationEndpoint : public std::enable_shared_from_this<PublicationEndpoint> {
 public:
  /// The endpoint of a publication, made with the first attachment and shared by all of the process. Null, with a
  /// warning, when there is no memory for it.
  static std::shared_ptr<PublicationEndpoint> of(const ros::PublicationPtr& publication,
                                                 const PublisherOptions& options, Worker& worker,
                                                 PeerPool& peers);
  ~PublicationEndpoint();

  const std::shared_ptr<MemorySource>& memory() const { return memory_; }
  OnExhausted on_exhausted() const { return stream_.records().on_exhausted(); }
  RecordEncoder& records() { return stream_.records(); }
  PublisherStatistics statistics() const;
  /// What the statistics page shows. Does not wait for a thread that publishes.
  EndpointStatistics look() const;
  bool wants_pointer(const std::type_info& type) const;
  LocalMessage local_message(const std::type_info& type, const message::Encoded& encoded) const;

  /// Sends an encoded message of a known type to all subscribers, past roscpp's own publish, without building
  /// a view. Does nothing and returns false unless every link of the publication is a SharedLink and nothing
  /// waits in its queue.
  bool publish_directly(const std::type_info& type, message::Encoded& encoded);

  /// Sends what waits in roscpp's queue, which a message that is published by pointer would overtake on a SharedLink.
  void send_queued();
  /// After send_queued(), writes the number into an encoded message of a known type that roscpp gives what is published by reference, and calls
  /// `publish`, which publishes a view of it by pointer.
  void publish_numbered(const std::type_info& type, message::Encoded& encoded, Others others,
                        const std::function<void()>& publish);

  /// roscpp's connect callback: offers shared memory to the subscriber.
  void on_connect(const ros::SingleSubscriberPublisher& subscriber);
  /// A subscriber of that name requests an offer.
  void offer_again(const std::string& caller_id);

 private:
  using TcpLink = ros::TransportSubscriberLinkPtr;

  PublicationEndpoint(const ros::PublicationPtr& publication, std::shared_ptr<SegmentMemory> memory,
                      OnExhausted on_exhausted, Worker& worker, PeerPool& peers);
  /// Whether a message of that type that is published by pointer advances the topic's sequence number.
  bool numbers_by_pointer(ros::Publication& publication, const std::type_info& type) const;
  bool is_listening();
  bool listen(std::size_t queue_size);
  bool authorizes(const channel::Credentials& peer, const std::string& token);
  void could_not_connect(const std::string& token, const Error& error);
  void invite(const TcpLink& link);
  void invite_later();

  const ros::PublicationWPtr publication_;
  const std::string topic_;
  const std::shared_ptr<SegmentMemory> segments_;
  const std::shared_ptr<MemorySource> memory_;
  Worker& worker_;
  PublicationStream stream_;
  const LocalCallbacks local_callbacks_;
  const std::shared_ptr<UpgradeNegotiator> negotiator_;
  const std::shared_ptr<LinkMigration> migration_;
  mutable std::mutex channel_mutex_;             ///< guards channel_; innermost, but for the channel's own
  std::shared_ptr<channel::Publisher> channel_;  ///< null until the first subscriber is invited
  bool invites_later_ = false;  ///< under channel_mutex_: the worker is to invite all that wait
};

/// The endpoint of a topic that this process advertises; null when there is none.
std::shared_ptr<PublicationEndpoint> find_endpoint(const std::string& topic);
/// Those of this process.
std::vector<std::shared_ptr<PublicationEndpoint>> all_endpoints();

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <ros/transport_subscriber_link.h>
#include <tzc/channel.h>

#include <memory>
#include <string>
#include <vector>

#include "roscpp/publish/publication_stream.h"
#include "roscpp/publish/shared_link.h"
#include "roscpp/upgrade/upgrade_negotiator.h"
#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// Moves the links of one publication between TCPROS and shared memory:
///
///   connected      the TCPROS link is parked, and a SharedLink stands in its place
///   disconnected   the channel broke: the TCPROS link is put back, and offered shared memory again after a while
///   (its TCPROS connection ends)   the SharedLink goes, and the user's disconnect callbacks are called
///
/// Runs on the worker thread, which may wait for roscpp's locks while another thread publishes.
class LinkMigration : public LinkEndListener, public std::enable_shared_from_this<LinkMigration> {
 public:
  LinkMigration(const ros::PublicationPtr& publication, std::shared_ptr<UpgradeNegotiator> negotiator,
                Worker& worker)
      : publication_(publication),
        topic_(publication->getName()),
        negotiator_(std::move(negotiator)),
        worker_(worker) {}

  /// Before the first connection. The links keep the stream, and with it its owner; this object does not.
  void send_from(const std::weak_ptr<PublicationStream>& stream) { stream_ = stream; }

  /// \name For the channel: any thread, which does not wait
  /// @{
  void connected_later(const channel::ConnectionPtr& connection);
  void disconnected_later(const channel::ConnectionPtr& connection);
  /// @}

  /// The links that take what is published. Valid while the caller holds subscriber_links_mutex_.
  const std::vector<SharedLink*>& live_links() const { return live_; }

 private:
  using TcpLink = ros::TransportSubscriberLinkPtr;
  using Progress = SharedLink::Progress;
  using Step = void (LinkMigration::*)(const SharedLinkPtr&, int looks);

  void connected(const channel::ConnectionPtr& connection);
  void disconnected(const channel::ConnectionPtr& connection);
  void watch(const SharedLinkPtr& link);
  SharedLinkPtr park_if_possible(const TcpLink& tcp, const channel::ConnectionPtr& connection);
  SharedLinkPtr park(const TcpLink& tcp, const channel::ConnectionPtr& connection);
  void go_live(const SharedLinkPtr& link, int looks);
  void come_back(const SharedLinkPtr& link, int looks);
  Progress try_come_back(ros::Publication& publication, const SharedLinkPtr& link);
  void ended(const SharedLinkPtr& link) override;
  void look_again(const SharedLinkPtr& link, int looks, Step step);
  void attempt(const SharedLinkPtr& link, int looks, Step step);

  /// \name Under subscriber_links_mutex_
  /// @{
  void remove_live(SharedLink& link);
  void put_back(ros::Publication& publication, const SharedLinkPtr& link);
  /// @}

  const ros::PublicationWPtr publication_;
  const std::string topic_;
  const std::shared_ptr<UpgradeNegotiator> negotiator_;
  Worker& worker_;
  std::weak_ptr<PublicationStream> stream_;

  /// \name Under subscriber_links_mutex_
  /// @{
  std::vector<SharedLink*> live_;  ///< they take what is published
  std::size_t standing_ = 0;       ///< all in the publication, also those that have returned to TCPROS
  /// @}

  struct Moved {
    channel::ConnectionPtr connection;
    boost::weak_ptr<SharedLink> link;
  };
  std::vector<Moved> moved_;  ///< worker's thread
};

}  // namespace detail
}  // namespace tzc

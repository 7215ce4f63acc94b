// SPDX-License-Identifier: BSD-3-Clause
/// The port's half of the move: from TCPROS to shared memory, and back.
#include <ros/connection.h>
#include <ros/console.h>
#include <ros/publication.h>

#include "posix/step.h"
#include "roscpp/link_swap.h"
#include "roscpp/port.h"
#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

/// How often a link that waits for somebody else to be done is looked at again.
constexpr std::chrono::microseconds kPoll(300);

}  // namespace

void Port::connected(const channel::ConnectionPtr& connection) {
  const TcpLink tcp = offering_->welcome(connection->hello());
  const SharedLinkPtr link = tcp ? park(tcp, connection) : SharedLinkPtr();
  if (!link) return connection->close();
  by_connection_[connection] = link;
  watch(link);
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << tcp->getDestinationCallerID()
                           << " goes through shared memory");
  go_live(link);
}

void Port::watch(const SharedLinkPtr& link) {
  const std::weak_ptr<Port> weak = weak_from_this();
  const boost::weak_ptr<SharedLink> weak_link = link;
  link->on_end([weak, weak_link] {
    const std::shared_ptr<Port> port = weak.lock();
    const SharedLinkPtr gone = weak_link.lock();
    if (port && gone) port->ended(gone);
  });
  if (link->parked()->getConnection()->isDropped()) ended(link);  // before the listener stood
}

SharedLinkPtr Port::park(const TcpLink& tcp, const channel::ConnectionPtr& connection) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return SharedLinkPtr();
  posix::step("move: begins");
  const Standstill standstill(*publication);
  const auto link =
      boost::make_shared<SharedLink>(shared_from_this(), publication, tcp, connection, standstill.queued());
  if (!swap_link_locked(*publication, tcp, link)) return SharedLinkPtr();
  if (links_++ == 0) track_queue(access::publish_queue_(*publication));
  ++standing_;
  posix::step("move: parked");
  return link;
}

void Port::go_live(const SharedLinkPtr& link) {
  if (link->connection()->alive() && !link->try_go_live()) look_again(link, &Port::go_live);
}

void Port::look_again(const SharedLinkPtr& link, void (Port::*act)(const SharedLinkPtr&)) {
  const std::weak_ptr<Port> weak = weak_from_this();
  const boost::weak_ptr<SharedLink> weak_link = link;
  const auto again = [weak, weak_link, act] {
    const std::shared_ptr<Port> port = weak.lock();
    const SharedLinkPtr waiting = weak_link.lock();
    if (port && waiting) (port.get()->*act)(waiting);
  };
  worker_.post(again, kPoll);
}

void Port::disconnected(const channel::ConnectionPtr& connection) {
  const auto found = by_connection_.find(connection);
  if (found == by_connection_.end()) return;
  const SharedLinkPtr link = found->second.lock();
  by_connection_.erase(found);
  if (link) come_back(link);
}

void Port::come_back(const SharedLinkPtr& link) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication || link->parked()->getConnection()->isDropped()) return;
  if (!try_come_back(*publication, link)) return look_again(link, &Port::come_back);
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << link->getDestinationCallerID() << " is back on TCPROS");
  offering_->lost(link->parked());
}

bool Port::try_come_back(ros::Publication& publication, const SharedLinkPtr& link) {
  const Standstill standstill(publication);
  if (!link->has_returned() && link->try_return(standstill.queued())) {
    --links_;
    posix::step("move: returned");
  }
  if (!link->may_be_replaced()) return false;
  put_back_locked(publication, link);
  return true;
}

void Port::put_back_locked(ros::Publication& publication, const SharedLinkPtr& link) {
  if (!swap_link_locked(publication, link, link->parked())) return;
  if (!link->has_returned()) --links_;
  if (--standing_ == 0) forget_queue();
}

void Port::ended(const SharedLinkPtr& link) {
  // With the TCPROS link in its old place, roscpp's own removal tells the user's disconnect callbacks.
  if (const ros::PublicationPtr publication = publication_.lock()) {
    {
      const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
      put_back_locked(*publication, link);
    }
    publication->removeSubscriberLink(link->parked());
  }
  link->connection()->close();
}

}  // namespace detail
}  // namespace tzc

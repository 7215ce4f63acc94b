// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/link_migration.h"

#include <ros/connection.h>
#include <ros/console.h>
#include <ros/init.h>
#include <ros/publication.h>

#include <algorithm>
#include <chrono>
#include <new>

#include "roscpp/publish/publication_lock.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/throttled_warning.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

constexpr int looks_in_a_hurry = 16, looks_of_the_patient = looks_in_a_hurry + 28;

/// When to check again a link that waits for another thread or process, after so many looks in vain: at first often,
/// because a move takes at most a few milliseconds, then less and less often, because a stopped process may keep it
/// waiting for long.
std::chrono::microseconds pause_before_look(int looks) {
  constexpr std::chrono::microseconds first(300), longest(20000);
  return looks < looks_in_a_hurry
             ? first
             : std::min(longest, first * (1 << std::min((looks - looks_in_a_hurry) / 4, 7)));
}

// A link that waits seldom would pass on less than is published, and never be done.
int looks_after(SharedLink::Progress progress, int looks) {
  return progress == SharedLink::Progress::some ? 0 : looks + 1;
}

}  // namespace

void LinkMigration::connected_later(const channel::ConnectionPtr& connection) {
  worker_.post([weak = weak_from_this(), connection] {
    if (const std::shared_ptr<LinkMigration> migration = weak.lock()) migration->connected(connection);
  });
}

void LinkMigration::disconnected_later(const channel::ConnectionPtr& connection) {
  worker_.post([weak = weak_from_this(), connection] {
    if (const std::shared_ptr<LinkMigration> migration = weak.lock()) migration->disconnected(connection);
  });
}

void LinkMigration::connected(const channel::ConnectionPtr& connection) {
  moved_.push_back({connection, {}});  // before the invitation is used up
  const TcpLink tcp = negotiator_->welcome(connection->hello());
  const SharedLinkPtr link = tcp ? park_if_possible(tcp, connection) : SharedLinkPtr();
  if (!link) {
    moved_.pop_back();
    connection->close();
    if (tcp) negotiator_->lost(tcp, "it came, and its link could not be moved");
    return;
  }
  moved_.back().link = link;
  try {
    watch(link);
  } catch (const std::exception&) {
    connection->close();  // and it comes back
    throw;
  }
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << tcp->getDestinationCallerID()
                           << " goes through shared memory");
  attempt(link, 0, &LinkMigration::go_live);
}

/// A step that found no memory is as one that found the link busy: what waits stays where it is.
void LinkMigration::attempt(const SharedLinkPtr& link, int looks, Step step) {
  try {
    (this->*step)(link, looks);
  } catch (const std::exception& error) {
    if (ros::isShuttingDown()) return;  // the log's locks may be gone
    TZC_WARN_THROTTLED_FOR(topic_, 10,
                           "TZC: " << topic_ << ": the move of the connection to "
                                   << link->getDestinationCallerID() << " is tried again: " << error.what());
    look_again(link, std::max(looks, looks_of_the_patient) + 1, step);
  }
}

void LinkMigration::watch(const SharedLinkPtr& link) {
  link->tell_of_end(weak_from_this());
  if (link->parked()->getConnection()->isDropped()) ended(link);  // before the listener was connected
}

SharedLinkPtr LinkMigration::park_if_possible(const TcpLink& tcp, const channel::ConnectionPtr& connection) {
  try {
    return park(tcp, connection);
  } catch (const std::bad_alloc&) {  // nothing has changed yet
    return SharedLinkPtr();
  }
}

SharedLinkPtr LinkMigration::park(const TcpLink& tcp, const channel::ConnectionPtr& connection) {
  const ros::PublicationPtr publication = publication_.lock();
  const std::shared_ptr<PublicationStream> stream = stream_.lock();
  if (!publication || !stream) return SharedLinkPtr();
  sync_point("move: begins");
  SharedLinkPtr link;  // its end takes mutexes that come before the publication's
  const PublicationLock lock(*publication);
  link = boost::make_shared<SharedLink>(stream, publication, tcp, connection, lock.queued());
  live_.reserve(live_.size() + 1);  // nothing may fail once it stands in roscpp's list
  stream->set_links(live_.size() + 1);
  if (!swap_to_front_locked(*publication, tcp, link)) {
    stream->set_links(live_.size());
    if (standing_ == 0) stream->forget_queue();
    return SharedLinkPtr();
  }
  live_.push_back(link.get());
  ++standing_;
  sync_point("move: parked");
  return link;
}

void LinkMigration::remove_live(SharedLink& link) {
  live_.erase(std::remove(live_.begin(), live_.end(), &link), live_.end());
  link.stream().set_links(live_.size());
}

void LinkMigration::go_live(const SharedLinkPtr& link, int looks) {
  if (!link->connection()->alive()) return;
  const Progress progress = link->try_go_live();
  if (progress != Progress::finished) look_again(link, looks_after(progress, looks), &LinkMigration::go_live);
}

void LinkMigration::look_again(const SharedLinkPtr& link, int looks, Step step) {
  const std::weak_ptr<LinkMigration> weak = weak_from_this();
  const boost::weak_ptr<SharedLink> weak_link = link;
  const auto again = [weak, weak_link, looks, step] {
    const std::shared_ptr<LinkMigration> migration = weak.lock();
    const SharedLinkPtr waiting = weak_link.lock();
    if (migration && waiting) migration->attempt(waiting, looks, step);
  };
  worker_.post(again, pause_before_look(looks));
}

void LinkMigration::disconnected(const channel::ConnectionPtr& connection) {
  const auto found = std::find_if(moved_.begin(), moved_.end(),
                                  [&](const Moved& one) { return one.connection == connection; });
  if (found == moved_.end()) return;
  const SharedLinkPtr link = found->link.lock();
  moved_.erase(found);
  if (link) attempt(link, 0, &LinkMigration::come_back);
}

void LinkMigration::come_back(const SharedLinkPtr& link, int looks) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication || link->parked()->getConnection()->isDropped()) return;
  const Progress progress = try_come_back(*publication, link);
  if (progress != Progress::finished)
    return look_again(link, looks_after(progress, looks), &LinkMigration::come_back);
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << link->getDestinationCallerID() << " is back on TCPROS");
  negotiator_->lost(link->parked(),
                    "it came, and the channel broke again; the warnings of both nodes say why");
}

LinkMigration::Progress LinkMigration::try_come_back(ros::Publication& publication,
                                                     const SharedLinkPtr& link) {
  const Progress handed = link->has_returned() ? Progress::finished : link->hand_back();
  if (handed != Progress::finished) return handed;
  const PublicationLock lock(publication);
  if (!link->has_returned() && link->try_return(lock.queued())) {
    remove_live(*link);
    sync_point("move: returned");
  }
  if (!link->may_be_replaced()) return Progress::none;
  put_back(publication, link);
  return Progress::finished;
}

void LinkMigration::put_back(ros::Publication& publication, const SharedLinkPtr& link) {
  remove_live(*link);
  if (!swap_link_locked(publication, link, link->parked())) return;
  if (--standing_ == 0) link->stream().forget_queue();
}

void LinkMigration::ended(const SharedLinkPtr& link) {
  // With the TCPROS link in its old place, roscpp's own removal calls the user's disconnect callbacks.
  if (const ros::PublicationPtr publication = publication_.lock()) {
    {
      const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
      put_back(*publication, link);
    }
    publication->removeSubscriberLink(link->parked());
  }
  link->connection()->close();
}

}  // namespace detail
}  // namespace tzc

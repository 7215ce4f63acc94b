// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/publication.h>
#include <ros/subscriber_link.h>
#include <ros/topic_manager.h>

#include <algorithm>

#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {

/// Replaces `old_link` by `new_link` among a publication's links; the caller holds their mutex. This calls no
/// connect callback and does not change the number of subscribers. False: `old_link` is not among them.
inline bool swap_link_locked(ros::Publication& publication, const ros::SubscriberLinkPtr& old_link,
                             const ros::SubscriberLinkPtr& new_link) {
  ros::V_SubscriberLink& links = roscpp_access::subscriber_links_(publication);
  const auto place = std::find(links.begin(), links.end(), old_link);
  if (place == links.end()) return false;
  *place = new_link;
  return true;
}

/// The same, but `new_link` gets what is published before all others. A message that is published by pointer is the
/// program's own object: after a link inside this process has passed it on, a callback may be writing to it.
inline bool swap_to_front_locked(ros::Publication& publication, const ros::SubscriberLinkPtr& old_link,
                                 const ros::SubscriberLinkPtr& new_link) {
  if (!swap_link_locked(publication, old_link, new_link)) return false;
  ros::V_SubscriberLink& links = roscpp_access::subscriber_links_(publication);
  const auto place = std::find(links.begin(), links.end(), new_link);
  std::rotate(links.begin(), place, place + 1);
  return true;
}

/// While it lives no thread publishes on the publication, changes its queue of serialized messages, or walks
/// its links. So it is exact which messages belong to a TCPROS link and which to its successor.
class PublicationLock {
 public:
  explicit PublicationLock(ros::Publication& publication)
      : topics_(roscpp_access::advertised_topics_mutex_(*ros::TopicManager::instance())),
        queue_(roscpp_access::publish_queue_mutex_(publication)),
        links_(roscpp_access::subscriber_links_mutex_(publication)),
        queued_(roscpp_access::publish_queue_(publication).size()) {}

  /// Serialized messages that no link has got yet.
  std::size_t queued() const { return queued_; }

 private:
  const boost::recursive_mutex::scoped_lock topics_;
  const boost::mutex::scoped_lock queue_;
  const boost::mutex::scoped_lock links_;
  const std::size_t queued_;
};

}  // namespace detail
}  // namespace tzc

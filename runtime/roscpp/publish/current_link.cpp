// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/current_link.h"

#include <ros/publication.h>
#include <ros/topic_manager.h>
#include <tzc/detail/attachment.h>

#include "roscpp/publish/shared_link.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/roscpp_version.h"

namespace tzc {
namespace detail {
namespace {

/// Itself, or the SharedLink that stands in its place, as long as the caller holds advertised_topics_mutex_.
ros::SubscriberLinkPtr standing_for(const ros::SubscriberLinkPtr& tcpros, ros::Publication& publication) {
  const boost::mutex::scoped_lock lock(roscpp_access::subscriber_links_mutex_(publication));
  for (const ros::SubscriberLinkPtr& link : roscpp_access::subscriber_links_(publication)) {
    const SharedLinkPtr shared = boost::dynamic_pointer_cast<SharedLink>(link);
    if (shared && shared->parked() == tcpros) return link;
  }
  return tcpros;
}

}  // namespace

CurrentLink::CurrentLink(const ros::SubscriberLinkPtr& tcpros) : tcpros_(tcpros) {
  topic_ = tcpros->getTopic();
  destination_caller_id_ = tcpros->getDestinationCallerID();
  connection_id_ = static_cast<unsigned int>(tcpros->getConnectionID());
}

void CurrentLink::enqueueMessage(const ros::SerializedMessage& message, bool ser, bool nocopy) {
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic_);
  if (!publication) return tcpros_->enqueueMessage(message, ser, nocopy);
  // No link moves meanwhile. Not a PublicationLock: see send_queue().
  const boost::recursive_mutex::scoped_lock lock(
      roscpp_access::advertised_topics_mutex_(*ros::TopicManager::instance()));
  standing_for(tcpros_, *publication)->enqueueMessage(message, ser, nocopy);
}

ros::SubscriberStatusCallback on_current_link(const ros::SubscriberStatusCallback& callback) {
  if (!callback || !is_roscpp_known()) return callback;
  return [callback](const ros::SingleSubscriberPublisher& subscriber) {
    const ros::SubscriberLinkPtr link =
        roscpp_access::link_(const_cast<ros::SingleSubscriberPublisher&>(subscriber));
    // One inside the process stays what it is. Where TZC stands before an advertisement twice, the other one has done it.
    if (link->isIntraprocess() || boost::dynamic_pointer_cast<CurrentLink>(link)) return callback(subscriber);
    callback(ros::SingleSubscriberPublisher(boost::make_shared<CurrentLink>(link)));
  };
}

}  // namespace detail
}  // namespace tzc

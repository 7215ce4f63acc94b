// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/local_writers.h"

#include <algorithm>

#include "roscpp/roscpp_access.h"
#include "roscpp/traces/traced_callback.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

/// Null when the link is not one inside this process, or has ended.
ros::SubscriptionPtr local_subscription(const ros::SubscriberLinkPtr& link) {
  const auto local = boost::dynamic_pointer_cast<ros::IntraProcessSubscriberLink>(link);
  if (!local) return ros::SubscriptionPtr();
  const boost::recursive_mutex::scoped_lock lock(access::drop_mutex_(*local));
  const ros::IntraProcessPublisherLinkPtr& other_end = access::subscriber_(*local);
  if (access::dropped_(*local) || !other_end) return ros::SubscriptionPtr();
  return access::parent_(*other_end).lock();
}

bool has_writers(ros::Subscription& subscription, const MessageCodec& codec) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  const auto& callbacks = access::callbacks_(subscription);
  return std::any_of(callbacks.begin(), callbacks.end(), [&](const auto& callback) {
    return callback->helper_->getTypeInfo() == *codec.type && !codec.only_reads(untraced(*callback->helper_));
  });
}

}  // namespace

bool has_local_writers(ros::Publication& publication, const MessageCodec& codec) {
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(publication));
  const ros::V_SubscriberLink& links = access::subscriber_links_(publication);
  return std::any_of(links.begin(), links.end(), [&](const ros::SubscriberLinkPtr& link) {
    const ros::SubscriptionPtr subscription = local_subscription(link);
    return subscription && has_writers(*subscription, codec);
  });
}

}  // namespace detail
}  // namespace tzc

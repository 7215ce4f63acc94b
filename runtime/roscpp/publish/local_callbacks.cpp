// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/local_callbacks.h"

#include <algorithm>

#include "roscpp/configuration.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/subscribe/writing_callback.h"

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

// roscpp copies for such a callback only when the subscription has others besides.
bool has_writers(ros::Subscription& subscription, const MessageCodec& codec) {
  const boost::mutex::scoped_lock lock(access::callbacks_mutex_(subscription));
  const auto& callbacks = access::callbacks_(subscription);
  return std::any_of(callbacks.begin(), callbacks.end(),
                     [&](const auto& callback) { return may_write(*callback->helper_, codec); });
}

}  // namespace

LocalView prepare_local_callbacks(ros::Publication& publication, const MessageCodec& codec) {
  LocalView view = LocalView::unseen;
  const bool is_latching = publication.isLatching();  // takes a mutex under which roscpp takes the next one
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(publication));
  for (const ros::SubscriberLinkPtr& link : access::subscriber_links_(publication)) {
    const ros::SubscriptionPtr subscription = local_subscription(link);
    if (!subscription) continue;
    // roscpp keeps what is latched for callbacks that come later, which are not ready for faults.
    if (is_latching || has_writers(*subscription, codec)) return LocalView::copy;
    if (!private_writes()) continue;
    make_ready_for_faults(*subscription, codec);
    view = LocalView::guarded;
  }
  return view;
}

}  // namespace detail
}  // namespace tzc

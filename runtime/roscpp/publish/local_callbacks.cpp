// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/local_callbacks.h"

#include <algorithm>

#include "roscpp/configuration.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/subscribe/writing_callback.h"
#include "roscpp/throttled_warning.h"

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

LocalView make_ready(ros::Publication& publication, const MessageCodec& codec) {
  LocalView view = LocalView::unseen;
  const bool is_latching = publication.isLatching();  // takes a mutex under which roscpp takes the next one
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(publication));
  for (const ros::SubscriberLinkPtr& link : access::subscriber_links_(publication)) {
    const ros::SubscriptionPtr subscription = local_subscription(link);
    if (!subscription) continue;
    // roscpp keeps what is latched for callbacks that come later, which are not ready for faults.
    if (is_latching || has_writers(*subscription, codec)) return LocalView::copy;
    view = private_writes() ? LocalView::private_pages : LocalView::borrowed;
    if (private_writes()) make_ready_for_faults(*subscription, codec);
  }
  return view;
}

std::uint64_t shared_bytes(const message::Encoded& encoded) {
  std::uint64_t size = 0;
  for (const BufferPtr& buffer : encoded.buffers) size += buffer->size();
  return size;
}

}  // namespace

LocalMessage LocalCallbacks::prepare(ros::Publication& publication, const MessageCodec& codec,
                                     const message::Encoded& encoded) const {
  const LocalView view = make_ready(publication, codec);
  if (view == LocalView::unseen || view == LocalView::copy) return {view, nullptr};
  if (view == LocalView::private_pages) keep_others_ready();
  const std::uint64_t bytes = shared_bytes(encoded);
  if (!may_hold(publication.getName(), bytes)) return {LocalView::copy, nullptr};
  return {view, limit_.hold(bytes, nullptr)};
}

// Callbacks of other topics may write to what these have kept.
void LocalCallbacks::keep_others_ready() const {
  if (others_are_kept_ready_ || others_are_kept_ready_.exchange(true)) return;
  peers_.post("", keep_all_ready_for_faults);
}

bool LocalCallbacks::may_hold(const std::string& topic, std::uint64_t bytes) const {
  if (limit_.allows(bytes)) return true;
  TZC_WARN_THROTTLED_FOR(topic + " in this process", 60,
                         "TZC: " << topic << ": subscribers in its publisher's process hold "
                                 << limit_.held_messages() << " messages (" << limit_.held_bytes()
                                 << " bytes) in its shared memory, of which they may hold "
                                 << limit_.most_bytes() << " bytes; further ones are copied for them. Call "
                                 << "their callbacks more often, keep fewer messages, or raise the "
                                 << "publisher's ~tzc/memory_size");
  return false;
}

}  // namespace detail
}  // namespace tzc

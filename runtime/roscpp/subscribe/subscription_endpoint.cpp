// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/subscribe/subscription_endpoint.h"

#include <ros/connection.h>
#include <tzc/direct_dispatch.h>

#include <algorithm>
#include <cstring>
#include <utility>

#include "channel/inspection.h"
#include "roscpp/before_exit.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/subscribe/direct_queue.h"
#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/subscribe/guest_call.h"
#include "roscpp/throttled_warning.h"
#include "roscpp/upgrade/offer.h"
#include "sync_point/sync_point.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {
namespace {

struct Bytes {
  const std::uint8_t* data;
  std::size_t size;
};

Bytes control_of(const channel::Message& message) {
  return {message.control(), message.control_size()};
}

/// What it takes of the publisher's memory.
std::uint64_t shared_bytes(const channel::Message& message) {
  std::uint64_t size = 0;
  for (const ConstBlock& block : message.blocks()) size += block.size;
  return size;
}

/// A received message as roscpp passes buffers around.
ros::SerializedMessage as_buffer(const channel::Message& message,
                                 const boost::shared_array<std::uint8_t>& buffer, std::size_t size) {
  ros::SerializedMessage given(buffer, size);
  given.message_start = buffer.get();
  if (trace::active) trace::recent().remember(buffer.get(), channel::trace_id(message));
  return given;
}

/// The bytes stay where they are. `hold` keeps them, and with them the message's blocks.
ros::SerializedMessage borrow(const channel::Message& message, Bytes bytes,
                              std::shared_ptr<const void> hold) {
  const boost::shared_array<std::uint8_t> buffer(
      const_cast<std::uint8_t*>(bytes.data),
      [hold = std::move(hold)](std::uint8_t*) mutable { hold.reset(); });
  return as_buffer(message, buffer, bytes.size);
}

/// Keeps nothing of the message.
ros::SerializedMessage copy(const channel::Message& message, Bytes bytes) {
  const boost::shared_array<std::uint8_t> buffer(new std::uint8_t[bytes.size]);
  std::copy_n(bytes.data, bytes.size, buffer.get());
  return as_buffer(message, buffer, bytes.size);
}

// roscpp's counters are plain words. One thread at a time adds to them; the statistics are read by another.
void add(std::uint64_t& counter, std::uint64_t more) {
  __atomic_store_n(&counter, counter + more, __ATOMIC_RELAXED);
}

/// A callback that is added later makes an object of its own from the bytes, as with TCPROS: this one may have been written to
/// by then, and would keep its memory from the publisher. What a link left that roscpp dropped meanwhile nobody would ever forget.
void forget_latched_object(ros::Subscription& subscription, const ros::PublisherLinkPtr& link) {
  const boost::mutex::scoped_lock lock(roscpp_access::callbacks_mutex_(subscription));
  // In the order of Subscription::addCallback.
  const boost::mutex::scoped_lock links_lock(roscpp_access::publisher_links_mutex_(subscription));
  auto& latched = roscpp_access::latched_messages_(subscription);
  const auto found = latched.find(link);
  if (found == latched.end()) return;
  const auto& links = roscpp_access::publisher_links_(subscription);
  if (std::find(links.begin(), links.end(), link) == links.end()) {
    latched.erase(found);
    return;
  }
  found->second.message.message.reset();
  found->second.message.type_info = nullptr;
}

}  // namespace

bool SubscriptionEndpoint::may_begin() {
  tcpros_drained_ = tcpros_.is_over(*connection_);
  return tcpros_drained_;
}

void SubscriptionEndpoint::take(const channel::MessagePtr& message) {
  const BeforeExit step;
  if (!step) return;
  // The first record is kSwitch, unless a short queue has dropped it.
  if (!tcpros_drained_) tcpros_.wait(*connection_);
  tcpros_drained_ = true;
  if (message->tag() == kSwitch) return take_switch(*message);
  const ros::SubscriptionPtr subscription = subscription_.lock();
  if (!subscription || subscription->isDropped()) return;
  sync_point("take: has the subscription");
  add(counted().messages_received_, 1);
  add(counted().bytes_received_, message->control_size());
  if (!calls_directly_) {
    if (message->tag() == kControlPart && take_as_guest(*subscription, message)) return;
    return take_indirectly(*subscription, message);
  }
  if (message->tag() == kControlPart && take_directly(*subscription, message)) return;
  {
    const DirectReaderScope scope;
    take_indirectly(*subscription, message);
  }
  run_direct_callbacks();
}

void SubscriptionEndpoint::take_indirectly(ros::Subscription& subscription,
                                           const channel::MessagePtr& message) {
  if (message->tag() == kControlPart) take_control_part(subscription, message);
  if (message->tag() == kWholeMessage) take_whole_message(subscription, message);
}

ros::PublisherLink::Stats& SubscriptionEndpoint::counted() const {
  return const_cast<ros::PublisherLink::Stats&>(link_->getStats());
}

void SubscriptionEndpoint::take_switch(const channel::Message& message) {
  std::uint64_t most_bytes = 0;  // a publisher of the previous release sends nothing
  if (message.control_size() < sizeof(most_bytes)) return;
  std::memcpy(&most_bytes, message.control(), sizeof(most_bytes));
  limit_.set_most_bytes(most_bytes);
}

bool SubscriptionEndpoint::may_hold(const channel::Message& message) const {
  if (limit_.allows(shared_bytes(message))) return true;
  TZC_WARN_THROTTLED_FOR(topic_ + " from " + link_->getCallerID(), 60,
                         "TZC: " << topic_ << ": this node holds " << limit_.held_messages() << " messages ("
                                 << limit_.held_bytes() << " bytes) in the shared memory of "
                                 << link_->getCallerID() << ", of which one subscriber may hold "
                                 << limit_.most_bytes() << " bytes; further ones are copied. Call its "
                                 << "callbacks more often, keep fewer messages, or raise the publisher's "
                                 << "~tzc/memory_size");
  return false;
}

std::shared_ptr<const void> SubscriptionEndpoint::hold(const channel::MessagePtr& message) const {
  return limit_.hold(shared_bytes(*message), message);
}

bool SubscriptionEndpoint::must_copy(const channel::Message& message, bool may_write) const {
  return may_write || !may_hold(message);
}

boost::shared_ptr<void> SubscriptionEndpoint::decode(const channel::MessagePtr& message, bool copied) const {
  const boost::shared_ptr<void> decoded =
      copied ? codec_.copy(message->control(), message->control_size(), message->blocks())
             : codec_.view(message->control(), message->control_size(), message->blocks(), hold(message));
  if (!decoded) {
    TZC_WARN_THROTTLED_FOR(
        topic_ + " from " + link_->getCallerID(), 10,
        "TZC: a malformed message on " << topic_ << " from " << link_->getCallerID() << " is dropped");
  }
  if (trace::active) trace::recent().remember(decoded.get(), channel::trace_id(*message));
  return decoded;
}

DirectMessage SubscriptionEndpoint::described() const {
  return {codec_, link_->isLatched(), connection_->getHeader().getValues()};
}

bool SubscriptionEndpoint::take_directly(ros::Subscription& subscription,
                                         const channel::MessagePtr& message) {
  DirectCall call =
      DirectCall::prepare(subscription, described(), *direct_dispatch_queue(), DirectCall::Turn::waits);
  if (!call) return false;
  call.call([&](bool may_write) { return decode(message, must_copy(*message, may_write)); },
            DirectCall::Thrown::ends_process);
  return true;
}

bool SubscriptionEndpoint::take_as_guest(ros::Subscription& subscription,
                                         const channel::MessagePtr& message) {
  HeardQueue* const queue = HeardQueue::of_guest();
  return queue != nullptr && leave_to_guest(*queue, subscription, described(), [&](bool may_write) {
           return decode(message, must_copy(*message, may_write));
         });
}

void SubscriptionEndpoint::take_control_part(ros::Subscription& subscription,
                                             const channel::MessagePtr& message) {
  const bool copied = must_copy(*message, make_ready_for_faults(subscription, codec_));
  const boost::shared_ptr<void> decoded = decode(message, copied);
  if (!decoded) return;
  bool ser = false, nocopy = false;
  subscription.getPublishTypes(ser, nocopy, *codec_.type);
  // Callbacks of another C++ type, and those that subscribe to a latched topic later, need the stock wire
  // format: one serialization here. Otherwise only topic statistics need bytes, the header, and the control
  // part begins with it.
  const bool needs_wire = ser || link_->isLatched();
  ros::SerializedMessage given = needs_wire ? in_wire_format(decoded)
                                 : copied   ? copy(*message, control_of(*message))
                                            : borrow(*message, control_of(*message), message);
  if (needs_wire && !given.buf) return;
  given.message = decoded;
  given.type_info = codec_.type;
  give(subscription, given, ser, true);
}

ros::SerializedMessage SubscriptionEndpoint::in_wire_format(const boost::shared_ptr<void>& decoded) const {
  try {
    return codec_.serialize(decoded.get());
  } catch (const ros::Exception& error) {  // over TCPROS it could not have come either
    TZC_WARN_THROTTLED_FOR(topic_ + " from " + link_->getCallerID(), 10,
                           "TZC: a message on "
                               << topic_ << " from " << link_->getCallerID()
                               << " is dropped: it does not fit roscpp's format: " << error.what());
    return ros::SerializedMessage();
  }
}

void SubscriptionEndpoint::take_whole_message(ros::Subscription& subscription,
                                              const channel::MessagePtr& message) {
  if (message->blocks().empty())
    return give(subscription, borrow(*message, control_of(*message), message), true, false);
  const ConstBlock& block = message->blocks().front();
  std::uint64_t size = 0;
  if (message->control_size() == sizeof(size)) std::memcpy(&size, message->control(), sizeof(size));
  if (size > block.size) return;
  const Bytes bytes{block.data, size};
  give(subscription, may_hold(*message) ? borrow(*message, bytes, hold(message)) : copy(*message, bytes),
       true, false);
}

void SubscriptionEndpoint::give(ros::Subscription& subscription, const ros::SerializedMessage& message,
                                bool ser, bool nocopy) {
  counted().drops_ +=
      subscription.handleMessage(message, ser, nocopy, connection_->getHeader().getValues(), link_);
  if (link_->isLatched()) forget_latched_object(subscription, link_);
}

}  // namespace detail
}  // namespace tzc

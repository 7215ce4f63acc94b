// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/queued_messages.h"

#include "roscpp/publish/record_encoder.h"
#include "roscpp/publish/shared_link.h"
#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

access::SerializedMessages take_queue(ros::Publication& publication) {
  access::SerializedMessages messages;
  const boost::mutex::scoped_lock lock(access::publish_queue_mutex_(publication));
  messages.swap(access::publish_queue_(publication));
  return messages;
}

/// Gives a link what needs no socket. False: the message goes to TCPROS.
bool takes_without_socket(ros::SubscriberLink& link, const ros::SerializedMessage& message) {
  if (auto* const shared = dynamic_cast<SharedLink*>(&link)) return shared->take_bytes(message);
  if (!link.isIntraprocess()) return false;
  link.enqueueMessage(message, true, false);
  return true;
}

void give_to_tcpros(ros::SubscriberLink& link, const ros::SerializedMessage& message) {
  if (auto* const shared = dynamic_cast<SharedLink*>(&link)) return shared->pass_to_tcpros(message);
  link.enqueueMessage(message, true, false);
}

/// Numbers the message, and gives it to all links but those that it returns.
ros::V_SubscriberLink send_without_sockets(ros::Publication& publication,
                                           const ros::SerializedMessage& message) {
  ros::V_SubscriberLink rest;
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(publication));
  if (publication.isDropped()) return rest;
  const std::uint32_t number = publication.incrementSequence();
  constexpr std::size_t length_prefix = 4;
  if (access::has_header_(publication))
    write_sequence(message.buf.get() + length_prefix, message.num_bytes - length_prefix, number);
  for (const ros::SubscriberLinkPtr& link : access::subscriber_links_(publication))
    if (!takes_without_socket(*link, message)) rest.push_back(link);
  return rest;
}

}  // namespace

void send_queue(ros::Publication& publication) {
  for (const ros::SerializedMessage& message : take_queue(publication))
    for (const ros::SubscriberLinkPtr& link : send_without_sockets(publication, message))
      give_to_tcpros(*link, message);
}

}  // namespace detail
}  // namespace tzc

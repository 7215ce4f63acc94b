// SPDX-License-Identifier: BSD-3-Clause
/// The port's half of the upgrade: inviting a TCPROS subscriber.
#include <ros/connection.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/publication.h>
#include <ros/this_node.h>

#include <random>

#include "posix/step.h"
#include "roscpp/connection_name.h"
#include "roscpp/host_identity.h"
#include "roscpp/offer.h"
#include "roscpp/port.h"
#include "roscpp/roscpp_access.h"
#include "roscpp/xmlrpc_call.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

/// Longer than any healthy node takes; a stopped one must not keep the worker from the others for long.
constexpr std::chrono::milliseconds kCallTimeout(2000);

/// Who has not come to the channel by then gets another offer, so many times.
constexpr std::chrono::seconds kPatience(3);
constexpr int kOffers = 4;

std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += std::to_string(random()) + ".";
  return token;
}

/// Where a node answers XMLRPC calls; empty when the master does not know it.
std::string node_uri(const std::string& caller_id) {
  XmlRpc::XmlRpcValue params;
  params[0] = ros::this_node::getName();
  params[1] = caller_id;
  XmlRpcReply reply = call_node(ros::master::getURI(), "lookupNode", params, kCallTimeout);
  const bool found = reply.succeeded() && reply.value.getType() == XmlRpc::XmlRpcValue::TypeString;
  return found ? static_cast<std::string>(reply.value) : std::string();
}

}  // namespace

void Port::on_connect(const ros::SingleSubscriberPublisher& subscriber) {
  const ros::SubscriberLinkPtr& link = access::link_(const_cast<ros::SingleSubscriberPublisher&>(subscriber));
  if (const auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link)) offer(tcp, kOffers);
}

void Port::offer_again(const std::string& caller_id) {
  const ros::PublicationPtr publication = publication_.lock();
  if (!publication) return;
  ros::V_SubscriberLink links;
  {
    const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
    links = access::subscriber_links_(*publication);
  }
  for (const ros::SubscriberLinkPtr& link : links) {
    const auto tcp = boost::dynamic_pointer_cast<ros::TransportSubscriberLink>(link);
    if (tcp && tcp->getDestinationCallerID() == caller_id) offer(tcp, kOffers);
  }
}

void Port::offer(const TcpLink& link, int offers_left) {
  if (link->getTransportType() != "TCPROS" || host_identity().empty()) return;
  const std::string& subscriber = link->getDestinationCallerID();
  const std::string uri = node_uri(subscriber);
  if (uri.empty()) return;
  Offer offer;
  offer.topic = topic_;
  offer.md5sum = md5sum_;
  offer.publisher = ros::this_node::getName();
  offer.address = channel_->address();
  offer.identity = host_identity();
  offer.connection = connection_name(*link->getConnection(), End::publisher);
  if (offer.connection.empty()) return;
  offer.token = expect(link);
  posix::step("offer: calls");
  const XmlRpcReply reply = call_node(uri, kOfferMethod, to_xmlrpc(offer), kCallTimeout);
  const bool refused = reply.unknown || (reply.answered && !reply.succeeded());
  if (!refused) return check_later(link, offer.token, offers_left - 1);
  expected(offer.token, true);
  ROS_DEBUG_STREAM("TZC: " << topic_ << " to " << subscriber << " stays on TCPROS: " << reply.status);
}

// An answer may be late, or the way to the channel may fail, on a machine that has a lot to do.
void Port::check_later(const TcpLink& link, const std::string& token, int offers_left) {
  const std::weak_ptr<Port> weak = weak_from_this();
  const boost::weak_ptr<ros::TransportSubscriberLink> weak_link = link;
  const auto check = [weak, weak_link, token, offers_left] {
    const std::shared_ptr<Port> port = weak.lock();
    const TcpLink waiting = weak_link.lock();
    if (!port || !waiting || waiting->getConnection()->isDropped()) return;
    const bool has_come = !port->expected(token, true);
    if (!has_come && offers_left > 0) port->offer(waiting, offers_left);
  };
  worker_.post(check, kPatience);
  posix::step("offer: waits");
}

std::string Port::expect(const TcpLink& link) {
  const std::string token = random_token();
  const std::lock_guard<std::mutex> lock(mutex_);
  for (auto it = expected_.begin(); it != expected_.end();)
    it = it->second.expired() ? expected_.erase(it) : std::next(it);
  expected_[token] = link;
  return token;
}

Port::TcpLink Port::expected(const std::string& token, bool take) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto found = expected_.find(token);
  if (found == expected_.end()) return TcpLink();
  const TcpLink link = found->second.lock();
  if (take) expected_.erase(found);
  return link;
}

}  // namespace detail
}  // namespace tzc

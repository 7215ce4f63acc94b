// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/offering.h"

#include <ros/connection.h>
#include <ros/console.h>
#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>
#include <random>

#include "posix/step.h"
#include "roscpp/configuration.h"
#include "roscpp/connection_name.h"
#include "roscpp/host_identity.h"
#include "roscpp/patience.h"
#include "roscpp/xmlrpc_call.h"

namespace tzc {
namespace detail {
namespace {

/// A channel that broke would mostly break again at once.
constexpr std::chrono::milliseconds kAfterLoss(5000);
/// Who was on shared memory for so long has a new set of tries.
constexpr std::chrono::minutes kLasting(1);

std::string random_token() {
  std::random_device random;
  std::string token;
  for (int i = 0; i < 4; ++i) token += std::to_string(random()) + ".";
  return token;
}

/// Where a node answers XMLRPC calls; empty, and the trouble is told, when that can't be learnt.
std::string node_uri(const std::string& node, std::string& trouble) {
  XmlRpc::XmlRpcValue params;
  params[0] = ros::this_node::getName();
  params[1] = node;
  const std::string& master = ros::master::getURI();
  XmlRpcReply reply = call_node(master, "lookupNode", params, kCallTimeout);
  if (reply.succeeded() && reply.value.getType() == XmlRpc::XmlRpcValue::TypeString)
    return static_cast<std::string>(reply.value);
  trouble = "the master at " + master + " does not say where that node is (" + reply.status +
            "); see that it runs and knows it: rosnode info " + node;
  return std::string();
}

bool is_gone(const Offering::TcpLink& link) {
  return !link || link->getConnection()->isDropped();
}

bool is_same(const boost::weak_ptr<ros::TransportSubscriberLink>& one, const Offering::TcpLink& other) {
  return !one.owner_before(other) && !other.owner_before(one);
}

}  // namespace

void Offering::invite(const TcpLink& link) {
  if (link->getTransportType() != "TCPROS" || host_identity().empty()) return;
  const InvitationPtr invitation = invitation_of(link);
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (invitation->token.empty()) {
      invitation->tries = 0;
      invitation->token = random_token();
    }
  }
  try_once(invitation);
}

// No link is locked under the mutex: who lets go of the last reference to it runs the user's callbacks.
Offering::InvitationPtr Offering::invitation_of(const TcpLink& link) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto is_over = [](const InvitationPtr& one) { return one->link.expired(); };
  invitations_.erase(std::remove_if(invitations_.begin(), invitations_.end(), is_over), invitations_.end());
  for (const InvitationPtr& one : invitations_)
    if (is_same(one->link, link)) return one;
  invitations_.push_back(std::make_shared<Invitation>());
  invitations_.back()->link = link;
  return invitations_.back();
}

Offering::InvitationPtr Offering::find(const std::string& token) const {
  for (const InvitationPtr& one : invitations_)
    if (!token.empty() && one->token == token) return one;
  return nullptr;
}

bool Offering::expects(const std::string& token) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return find(token) != nullptr;
}

Offering::TcpLink Offering::welcome(const std::string& token) {
  InvitationPtr invitation;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    invitation = find(token);
    if (!invitation) return TcpLink();
    invitation->came = Clock::now();
    invitation->token.clear();
  }
  return invitation->link.lock();
}

void Offering::turn_away(const std::string& token, const std::string& why) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const InvitationPtr invitation = find(token)) invitation->token.clear();
  }
  ROS_DEBUG_STREAM("TZC: a subscriber of " << offer_.topic << " stays on TCPROS: " << why);
}

void Offering::lost(const TcpLink& link) {
  if (is_gone(link)) return;
  const InvitationPtr invitation = invitation_of(link);
  std::chrono::milliseconds pause;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (Clock::now() - invitation->came > kLasting) invitation->tries = 0;
    invitation->token = random_token();
    invitation->trouble = "it came, and the channel broke again; the warnings of both nodes say why";
    pause = std::max(kAfterLoss, pause_after(invitation->tries));
  }
  look_later(invitation, pause);
}

void Offering::try_once(const InvitationPtr& invitation) {
  const TcpLink link = invitation->link.lock();
  if (is_gone(link)) return;
  const std::string& subscriber = link->getDestinationCallerID();
  const Offer offer = next_offer(*invitation, link);
  const Answer answer = ask(subscriber, offer);
  if (answer.refused) return turn_away(offer.token, subscriber + ": " + answer.text);
  int tries = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    invitation->trouble = answer.text;
    tries = invitation->tries;
  }
  ROS_DEBUG_STREAM("TZC: " << offer_.topic << " to " << subscriber << ", try " << tries
                           << "; if it does not come: " << answer.text);
  look_later(invitation, pause_after(tries));
  posix::step("offer: waits");
}

Offer Offering::next_offer(Invitation& invitation, const TcpLink& link) {
  Offer offer = offer_;
  offer.connection = connection_name(*link->getConnection(), End::publisher);
  const std::lock_guard<std::mutex> lock(mutex_);
  ++invitation.tries;
  offer.token = invitation.token;
  return offer;
}

Offering::Answer Offering::ask(const std::string& subscriber, const Offer& offer) {
  if (offer.connection.empty()) return {false, "its TCPROS connection has no ports"};
  std::string trouble;
  const std::string uri = node_uri(subscriber, trouble);
  if (uri.empty()) return {false, trouble};
  posix::step("offer: calls");
  const XmlRpcReply reply = call_node(uri, kOfferMethod, to_xmlrpc(offer), kCallTimeout);
  if (reply.succeeded())
    return {false, "it took the offer and did not come; its log says why, at debug level"};
  if (reply.unknown || reply.answered) return {true, reply.status};
  return {false, reply.status + "; does this address lead to it (ROS_IP, ROS_HOSTNAME), and does it run?"};
}

void Offering::look_later(const InvitationPtr& invitation, std::chrono::milliseconds pause) {
  int round = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    round = ++invitation->round;
  }
  const std::weak_ptr<Offering> weak = weak_from_this();
  const auto look = [weak, invitation, round] {
    if (const std::shared_ptr<Offering> offering = weak.lock()) offering->look(invitation, round);
  };
  caller_.post(look, pause);
}

void Offering::look(const InvitationPtr& invitation, int round) {
  const TcpLink link = invitation->link.lock();
  if (is_gone(link)) return;
  bool was_last = false;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (invitation->token.empty() || invitation->round != round) return;
    was_last = invitation->tries >= most_tries();
    if (was_last) invitation->token.clear();
  }
  was_last ? give_up(*invitation, link->getDestinationCallerID()) : try_once(invitation);
}

void Offering::give_up(const Invitation& invitation, const std::string& subscriber) const {
  ROS_WARN_STREAM_THROTTLE(10, "TZC: " << offer_.topic << " to " << subscriber << " stays on TCPROS after "
                                       << invitation.tries << " tries: " << invitation.trouble
                                       << ". Its messages arrive, but serialized; it is asked again when it "
                                          "subscribes anew");
}

}  // namespace detail
}  // namespace tzc

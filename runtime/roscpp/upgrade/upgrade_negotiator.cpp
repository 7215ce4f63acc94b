// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/upgrade/upgrade_negotiator.h"

#include <ros/connection.h>

#include <ros/master.h>
#include <ros/this_node.h>

#include <algorithm>

#include "channel/nonce.h"
#include "roscpp/configuration.h"
#include "roscpp/descriptor_budget.h"
#include "roscpp/throttled_warning.h"
#include "roscpp/upgrade/connection_name.h"
#include "roscpp/upgrade/host_identity.h"
#include "roscpp/upgrade/other_version.h"
#include "roscpp/upgrade/retry_policy.h"
#include "roscpp/upgrade/xmlrpc_call.h"
#include "sync_point/sync_point.h"

namespace tzc {
namespace detail {
namespace {

/// The pause before a new invitation: a channel that broke would often break again at once.
constexpr std::chrono::milliseconds kAfterLoss(5000);
/// A subscriber that was on shared memory for this long starts with the full number of tries.
constexpr std::chrono::minutes kLasting(1);

/// The URI where a node answers XMLRPC calls. When it cannot be found: empty, with the reason in `trouble`.
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

bool is_gone(const UpgradeNegotiator::TcpLink& link) {
  return !link || link->getConnection()->isDropped();
}

}  // namespace

void UpgradeNegotiator::invite(const TcpLink& link) {
  if (link->getTransportType() != "TCPROS") return;
  InvitationPtr invitation;
  int round = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    invitation = invitation_of(link);
    if (!invitation) return;
    if (invitation->token.empty() || invitation->warned) invitation->tries = 0;
    if (invitation->token.empty()) invitation->token = channel::nonce();
    invitation->warned = false;
    round = ++invitation->round;
  }
  post(invitation, round, std::chrono::milliseconds(0), &UpgradeNegotiator::begin);
}

void UpgradeNegotiator::begin(const InvitationPtr& invitation, int round) {
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (invitation->token.empty() || invitation->round != round) return;
  }
  try_once(invitation);
}

// Never lock() a link under mutex_: dropping the last reference runs user callbacks.
UpgradeNegotiator::InvitationPtr UpgradeNegotiator::invitation_of(const TcpLink& link) {
  if (accepted_.has(link)) return nullptr;
  const auto is_over = [](const InvitationPtr& one) { return one->link.expired(); };
  invitations_.erase(std::remove_if(invitations_.begin(), invitations_.end(), is_over), invitations_.end());
  for (const InvitationPtr& one : invitations_)
    if (is_same(one->link, link)) return one;
  invitations_.push_back(std::make_shared<Invitation>());
  invitations_.back()->link = link;
  invitations_.back()->subscriber = link->getDestinationCallerID();
  return invitations_.back();
}

UpgradeNegotiator::InvitationPtr UpgradeNegotiator::find(const std::string& token) const {
  for (const InvitationPtr& one : invitations_)
    if (!token.empty() && one->token == token) return one;
  return nullptr;
}

bool UpgradeNegotiator::expects(const std::string& token) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return find(token) != nullptr;
}

UpgradeNegotiator::TcpLink UpgradeNegotiator::welcome(const std::string& token) {
  InvitationPtr invitation;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    invitation = find(token);
    if (!invitation) return TcpLink();
    accepted_.add({invitation->link, Clock::now(), invitation->tries, invitation->warned});
    invitations_.erase(std::find(invitations_.begin(), invitations_.end(), invitation));
    invitation->token.clear();  // ends what is planned for it
  }
  return invitation->link.lock();
}

void UpgradeNegotiator::failed(const std::string& token, const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const InvitationPtr invitation = find(token)) invitation->trouble = why;
}

void UpgradeNegotiator::turn_away(const std::string& token, const std::string& why) {
  std::string subscriber = "a subscriber that is gone";
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (const InvitationPtr invitation = find(token)) {
      invitation->token.clear();
      invitation->trouble = why;
      subscriber = invitation->subscriber;
    }
  }
  ROS_DEBUG_STREAM("TZC: " << offer_.topic << " to " << subscriber << " stays on TCPROS: " << why);
}

void UpgradeNegotiator::leave(const TcpLink& link, const std::string& why) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (const InvitationPtr invitation = invitation_of(link)) invitation->trouble = why;
}

// The link is not locked: dropping the last reference runs user callbacks.
std::string UpgradeNegotiator::why_not(const boost::weak_ptr<ros::TransportSubscriberLink>& link) const {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (accepted_.has(link)) return "it has accepted; its link is being moved";
  for (const InvitationPtr& one : invitations_) {
    if (!is_same(one->link, link)) continue;
    const std::string tries = std::to_string(one->tries) + (one->tries == 1 ? " try: " : " tries: ");
    if (one->warned && !one->token.empty())
      return "asked again, at last every five minutes, after " + tries + one->trouble;
    if (!one->token.empty() && one->tries > 0) return "asked again soon, after " + tries + one->trouble;
    if (!one->trouble.empty()) return one->trouble;
  }
  return "shared memory was not offered yet";
}

void UpgradeNegotiator::lost(const TcpLink& link, const std::string& why) {
  if (is_gone(link)) return;
  InvitationPtr invitation;
  std::chrono::milliseconds pause;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::optional<AcceptedLinks::Accepted> before = accepted_.take(link);
    invitation = invitation_of(link);
    if (before && Clock::now() - before->at <= kLasting) invitation->tries = before->tries;
    if (before) invitation->warned = before->warned;
    invitation->token = channel::nonce();
    invitation->trouble = why;
    pause = std::max(kAfterLoss, pause_after(invitation->tries));
  }
  look_later(invitation, pause);
}

void UpgradeNegotiator::try_once(const InvitationPtr& invitation) {
  const TcpLink link = invitation->link.lock();
  if (is_gone(link)) return;
  const std::string& subscriber = link->getDestinationCallerID();
  const Offer offer = next_offer(*invitation, link);
  const Answer answer = ask(subscriber, offer);
  if (answer.refused && answer.text == kOtherVersionStatus) warn_of_other_version(subscriber, offer.topic);
  if (answer.refused) return turn_away(offer.token, answer.text);
  int tries = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    invitation->trouble = answer.text;
    tries = invitation->tries;
  }
  ROS_DEBUG_STREAM("TZC: " << offer_.topic << " to " << subscriber << ", try " << tries
                           << "; if it does not come: " << answer.text);
  look_later(invitation, pause_after(tries));
  sync_point("offer: waits");
}

Offer UpgradeNegotiator::next_offer(Invitation& invitation, const TcpLink& link) {
  const std::string connection = connection_name(*link->getConnection(), End::publisher);
  const std::lock_guard<std::mutex> lock(mutex_);
  Offer offer = offer_;
  offer.identity = host_identity();
  offer.connection = connection;
  ++invitation.tries;
  offer.token = invitation.token;
  return offer;
}

UpgradeNegotiator::Answer UpgradeNegotiator::ask(const std::string& subscriber, const Offer& offer) {
  if (!has_spare_descriptors()) return {false, "the publisher: " + descriptor_advice()};
  if (offer.identity.empty()) return {true, "this system does not name its boot or network namespace"};
  if (offer.connection.empty()) return {false, "its TCPROS connection has no endpoints"};
  std::string trouble;
  const std::string uri = node_uri(subscriber, trouble);
  if (uri.empty()) return {false, trouble};
  sync_point("offer: calls");
  const XmlRpcReply reply = call_node(uri, kOfferMethod, to_xmlrpc(offer), kCallTimeout);
  if (reply.succeeded() && reply.status != kComingStatus) return {false, reply.status};
  if (reply.succeeded())
    return {false, "it took the offer and did not come; its log says why, at debug level"};
  if (reply.unknown || reply.answered) return {true, reply.status};
  return {false, reply.status + "; does this address lead to it (ROS_IP, ROS_HOSTNAME), and does it run?"};
}

void UpgradeNegotiator::look_later(const InvitationPtr& invitation, std::chrono::milliseconds pause) {
  int round = 0;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    round = ++invitation->round;
  }
  post(invitation, round, pause, &UpgradeNegotiator::look);
}

void UpgradeNegotiator::post(const InvitationPtr& invitation, int round, std::chrono::milliseconds pause,
                             void (UpgradeNegotiator::*act)(const InvitationPtr&, int)) {
  const std::weak_ptr<UpgradeNegotiator> weak = weak_from_this();
  const auto job = [weak, invitation, round, act] {
    if (const std::shared_ptr<UpgradeNegotiator> negotiator = weak.lock())
      (negotiator.get()->*act)(invitation, round);
  };
  peers_.post(invitation->subscriber, job, pause);
}

void UpgradeNegotiator::look(const InvitationPtr& invitation, int round) {
  const TcpLink link = invitation->link.lock();
  if (is_gone(link)) return;
  bool is_time_to_warn = false;
  int tries = 0;
  std::string trouble;
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    if (invitation->token.empty() || invitation->round != round) return;
    is_time_to_warn = !invitation->warned && invitation->tries >= upgrade_attempts_until_warning();
    invitation->warned |= is_time_to_warn;
    tries = invitation->tries;
    trouble = invitation->trouble;
  }
  if (is_time_to_warn) warn(link->getDestinationCallerID(), tries, trouble);
  try_once(invitation);
}

void UpgradeNegotiator::warn(const std::string& subscriber, int tries, const std::string& trouble) const {
  TZC_WARN_THROTTLED_FOR(offer_.topic + " to " + subscriber, 10,
                         "TZC: " << offer_.topic << " to " << subscriber << " stays on TCPROS after " << tries
                                 << " tries: " << trouble
                                 << ". Its messages arrive, but serialized; it is asked again, at "
                                    "last every five minutes, and when it subscribes anew");
}

}  // namespace detail
}  // namespace tzc

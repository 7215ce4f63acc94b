// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/transport_subscriber_link.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "roscpp/upgrade/accepted_links.h"
#include "roscpp/upgrade/offer.h"
#include "roscpp/upgrade/peer_pool.h"

namespace tzc {
namespace detail {

/// Invites the TCPROS subscribers of one topic to its channel:
///
///   invite -> the master tells where the node is -> the node is called with the offer -> it comes, with the
///   token
///     ^                     │                                   │                     │
///     └── a longer pause ───┴──── no answer ────────────────────┴── it does not come ─┘
///
/// A failed upgrade is retried until the subscriber connects, with a warning after some tries. They end before
/// that only when its TCPROS connection ends, or when it refuses (no TZC, another machine, user, type or
/// version). Thread-safe.
class UpgradeNegotiator : public std::enable_shared_from_this<UpgradeNegotiator> {
 public:
  using TcpLink = ros::TransportSubscriberLinkPtr;

  /// @param offer the fields that are the same for every subscriber
  /// @param peers calls the master and the subscribers, and waits for them
  UpgradeNegotiator(Offer offer, PeerPool& peers) : offer_(std::move(offer)), peers_(peers) {}
  /// Before the first invitation.
  void listens_at(const std::string& address) {
    const std::lock_guard<std::mutex> lock(mutex_);
    offer_.address = address;
  }

  /// Invites the subscriber as soon as the pool has a thread, also when it was invited before, unless it has come. Does not
  /// block.
  void invite(const TcpLink& link);
  /// Whether a subscriber with this token is invited and has not connected yet.
  bool expects(const std::string& token) const;
  /// The subscriber with this token has connected; returns its link. Null: no such subscriber is expected.
  TcpLink welcome(const std::string& token);
  /// The subscriber with this token may not connect, and is not invited again.
  void turn_away(const std::string& token, const std::string& why);
  /// The subscriber with this token has come and could not connect; it is invited again later.
  void failed(const std::string& token, const std::string& why);
  /// The subscriber is not invited, for this reason.
  void leave(const TcpLink& link, const std::string& why);
  /// For people: why the subscriber behind a TCPROS link is not on shared memory, or not yet.
  std::string why_not(const boost::weak_ptr<ros::TransportSubscriberLink>& link) const;
  /// A subscriber that had come is on TCPROS, again or still, and its connection lives: invites it again after a while. The
  /// caller must hold no lock of roscpp's: a connection that ends holds its own and waits for those.
  void lost(const TcpLink& link, const std::string& why);

 private:
  using Clock = std::chrono::steady_clock;

  /// Under mutex_, but for its link.
  struct Invitation {
    boost::weak_ptr<ros::TransportSubscriberLink> link;
    std::string subscriber;  ///< its caller id
    std::string token;       ///< empty: no invitation is open
    std::string trouble;     ///< why the last try failed, or why there is none
    int tries = 0;
    int round = 0;        ///< number of the last planned check; earlier ones do nothing
    bool warned = false;  ///< after so many tries
  };
  using InvitationPtr = std::shared_ptr<Invitation>;
  struct Answer {
    bool refused;
    std::string text;  ///< why it was refused, or the likely reason if the subscriber does not connect
  };

  /// Under mutex_. Null: it is in accepted_.
  InvitationPtr invitation_of(const TcpLink& link);
  InvitationPtr find(const std::string& token) const;
  void begin(const InvitationPtr& invitation, int round);
  void try_once(const InvitationPtr& invitation);
  Offer next_offer(Invitation& invitation, const TcpLink& link);
  static Answer ask(const std::string& subscriber, const Offer& offer);
  void post(const InvitationPtr& invitation, int round, std::chrono::milliseconds pause,
            void (UpgradeNegotiator::*act)(const InvitationPtr&, int));
  void look_later(const InvitationPtr& invitation, std::chrono::milliseconds pause);
  void look(const InvitationPtr& invitation, int round);
  void warn(const std::string& subscriber, int tries, const std::string& trouble) const;

  Offer offer_;
  PeerPool& peers_;
  mutable std::mutex mutex_;
  std::vector<InvitationPtr> invitations_;  ///< one for each link that is not in accepted_
  AcceptedLinks accepted_;                  ///< there is nothing to invite to
};

}  // namespace detail
}  // namespace tzc

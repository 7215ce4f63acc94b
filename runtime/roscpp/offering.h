// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/transport_subscriber_link.h>

#include <chrono>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "roscpp/offer.h"
#include "roscpp/worker.h"

namespace tzc {
namespace detail {

/// Invites the TCPROS subscribers of one topic to its channel:
///
///   invite -> the master tells where the node is -> the node is called with the offer -> it comes, with the
///   token
///     ^                     │                                   │                     │
///     └── a longer pause ───┴──── no answer ────────────────────┴── it does not come ─┘
///
/// Nobody stays on TCPROS by accident. What ends the tries before the subscriber has come: the end of its
/// connection; a refusal (no TZC, another machine, user, type or version); and, with a warning, their number.
/// Thread-safe.
class Offering : public std::enable_shared_from_this<Offering> {
 public:
  using TcpLink = ros::TransportSubscriberLinkPtr;

  /// @param offer what is the same for every subscriber
  /// @param caller calls the master and the subscribers, and waits for them
  Offering(Offer offer, Worker& caller) : offer_(std::move(offer)), caller_(caller) {}
  /// Before the first invitation.
  void listens_at(const std::string& address) { offer_.address = address; }

  /// At once, also who has been invited before. Blocks: on the caller's thread.
  void invite(const TcpLink& link);
  /// Is somebody expected with this token?
  bool expects(const std::string& token) const;
  /// Who is expected with this token has come; the link that is meant. Null: nobody is.
  TcpLink welcome(const std::string& token);
  /// Who is expected with this token may not come, nor be asked again.
  void turn_away(const std::string& token, const std::string& why);
  /// Who had come is on TCPROS again, though its connection lives: it is invited again after a while. The
  /// caller holds no lock of roscpp's: a connection that ends holds its own and waits for those.
  void lost(const TcpLink& link);

 private:
  using Clock = std::chrono::steady_clock;

  /// Under mutex_, but for its link.
  struct Invitation {
    boost::weak_ptr<ros::TransportSubscriberLink> link;
    std::string token;  ///< empty: nobody is expected
    int tries = 0;
    int round = 0;  ///< the last look that was planned; earlier ones are void
    Clock::time_point came;
    std::string trouble;  ///< why the last try was in vain
  };
  using InvitationPtr = std::shared_ptr<Invitation>;
  struct Answer {
    bool refused;
    std::string text;  ///< why it was refused, or what to think if nobody comes
  };

  InvitationPtr invitation_of(const TcpLink& link);
  InvitationPtr find(const std::string& token) const;
  void try_once(const InvitationPtr& invitation);
  Offer next_offer(Invitation& invitation, const TcpLink& link);
  static Answer ask(const std::string& subscriber, const Offer& offer);
  void look_later(const InvitationPtr& invitation, std::chrono::milliseconds pause);
  void look(const InvitationPtr& invitation, int round);
  void give_up(const Invitation& invitation, const std::string& subscriber) const;

  Offer offer_;
  Worker& caller_;
  mutable std::mutex mutex_;
  std::vector<InvitationPtr> invitations_;  ///< one for each link
};

}  // namespace detail
}  // namespace tzc

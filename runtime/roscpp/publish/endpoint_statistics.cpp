// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/publish/endpoint_statistics.h"

#include <boost/thread/lock_types.hpp>

#include "roscpp/publish/shared_link.h"
#include "roscpp/roscpp_access.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;
using statistics::Transport;

/// A link, with what is to be asked for once roscpp's lock is released.
struct SeenLink {
  LinkStatistics statistics;
  channel::ConnectionPtr connection;                     ///< on shared memory
  boost::weak_ptr<ros::TransportSubscriberLink> tcpros;  ///< on TCPROS
};

Transport transport_of(ros::SubscriberLink& link) {
  const std::string type = link.getTransportType();
  if (type == "TZC") return Transport::shared;
  if (type == "TCPROS") return Transport::tcpros;
  return type == "UDPROS" ? Transport::udpros : Transport::intraprocess;
}

SeenLink see(const ros::SubscriberLinkPtr& link) {
  SeenLink seen;
  LinkStatistics& statistics = seen.statistics;
  statistics.subscriber = link->getDestinationCallerID();
  statistics.transport = transport_of(*link);
  if (statistics.transport == Transport::shared) {
    const SharedLink& shared = static_cast<const SharedLink&>(*link);
    seen.connection = shared.connection();
    if (shared.has_returned()) {
      statistics.transport = Transport::tcpros;
      statistics.reason = "its channel broke; the connection goes back to TCPROS";
    }
  } else if (statistics.transport == Transport::tcpros) {
    seen.tcpros = boost::static_pointer_cast<ros::TransportSubscriberLink>(link);
  }
  if (!seen.connection) {
    statistics.messages = link->getStats().messages_sent_;
    statistics.bytes = link->getStats().bytes_sent_;
  }
  return seen;
}

void ask_connection(channel::Connection& connection, LinkStatistics& statistics) {
  statistics.in_flight = connection.in_flight();
  statistics.inspection = channel::inspect(connection);
  const channel::ConnectionStats stats = connection.stats();
  statistics.messages = stats.sent;
  statistics.bytes = stats.bytes;
  statistics.revoked = stats.dropped;
  statistics.pid = static_cast<std::uint32_t>(connection.peer().pid);
}

LinkStatistics complete(SeenLink& seen, const WhyNot& why_not) {
  LinkStatistics& statistics = seen.statistics;
  if (seen.connection) ask_connection(*seen.connection, statistics);
  if (statistics.transport == Transport::udpros) statistics.reason = "the subscriber asked for UDPROS";
  if (statistics.transport == Transport::intraprocess)
    statistics.reason = "it is in the same process and gets the message itself";
  if (statistics.transport == Transport::tcpros && statistics.reason.empty())
    statistics.reason = why_not(seen.tcpros);
  return std::move(statistics);
}

}  // namespace

// The links are not kept beyond the lock: the last reference to one would run user callbacks on this thread.
bool read_links(ros::Publication& publication, const WhyNot& why_not, std::vector<LinkStatistics>& links) {
  std::vector<SeenLink> seen;
  {
    const boost::unique_lock<boost::mutex> lock(access::subscriber_links_mutex_(publication),
                                                boost::try_to_lock);
    if (!lock.owns_lock()) return false;
    for (const ros::SubscriberLinkPtr& link : access::subscriber_links_(publication))
      seen.push_back(see(link));
  }
  links.clear();
  for (SeenLink& link : seen) links.push_back(complete(link, why_not));
  return true;
}

}  // namespace detail
}  // namespace tzc

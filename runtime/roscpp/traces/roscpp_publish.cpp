// SPDX-License-Identifier: BSD-3-Clause
#include "tzc/detail/roscpp_publish.h"

#include <ros/publication.h>
#include <ros/this_node.h>
#include <ros/topic_manager.h>

#include <vector>

#include "roscpp/roscpp_access.h"
#include "roscpp/roscpp_version.h"
#include "roscpp/traces/tcpros_message.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {
namespace {

namespace access = roscpp_access;

std::vector<std::string> tcpros_subscribers(const std::string& topic) {
  std::vector<std::string> names;
  if (!is_roscpp_known()) return names;
  const ros::PublicationPtr publication = ros::TopicManager::instance()->lookupPublication(topic);
  if (!publication) return names;
  const boost::mutex::scoped_lock lock(access::subscriber_links_mutex_(*publication));
  for (const ros::SubscriberLinkPtr& link : access::subscriber_links_(*publication))
    if (link->getTransportType() == "TCPROS") names.push_back(link->getDestinationCallerID());
  return names;
}

}  // namespace

bool writes_trace = trace::active;

RoscppPublish::RoscppPublish(const std::string& topic, const ros::Time* stamp)
    : topic_(topic), stamp_(stamp != nullptr ? *stamp : ros::Time()), begin_ns_(trace::now()) {}

// roscpp sends on a thread of its own, later: what ends here is that it has taken the message.
RoscppPublish::~RoscppPublish() {
  const std::uint64_t end_ns = trace::now();
  static const bool is_named = (trace::name_process(ros::this_node::getName()), true);
  (void)is_named;
  const char* const topic = trace::keep(topic_);
  for (const std::string& subscriber : tcpros_subscribers(topic_)) {
    const std::uint64_t message =
        trace_id({topic_, ros::this_node::getName(), subscriber, stamp_.sec, stamp_.nsec});
    trace::record(
        {begin_ns_, end_ns, message, 0, topic, 0, trace::Step::roscpp_publish, trace::Arrow::begins});
  }
}

}  // namespace detail
}  // namespace tzc

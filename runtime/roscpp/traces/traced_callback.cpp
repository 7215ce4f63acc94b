// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/traces/traced_callback.h"

#include <ros/this_node.h>

#include <cstring>
#include <utility>

#include "roscpp/traces/tcpros_message.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {

TracedCallback::TracedCallback(ros::SubscriptionCallbackHelperPtr callback, const std::string& resolved_topic)
    : callback_(std::move(callback)), topic_(trace::keep(resolved_topic)) {
  trace::name_process(ros::this_node::getName());
}

// Bytes are a message that came over TCPROS, or one that was sent whole through shared memory: SubscriptionEndpoint
// remembers where that one's bytes are.
ros::VoidConstPtr TracedCallback::deserialize(
    const ros::SubscriptionCallbackHelperDeserializeParams& params) {
  ros::VoidConstPtr message = callback_->deserialize(params);
  const std::uint64_t shared = trace::recent().take(params.buffer);
  trace::recent().remember(message.get(), shared != 0 ? shared : came_over_tcpros(params));
  return message;
}

// A header comes first in its message: seq, stamp, frame_id.
std::uint64_t TracedCallback::came_over_tcpros(
    const ros::SubscriptionCallbackHelperDeserializeParams& params) {
  std::uint32_t header[3];
  if (!callback_->hasHeader() || params.length < sizeof header || !params.connection_header) return 0;
  const auto publisher = params.connection_header->find("callerid");
  if (publisher == params.connection_header->end()) return 0;
  std::memcpy(header, params.buffer, sizeof header);
  return trace_id({topic_, publisher->second, ros::this_node::getName(), header[1], header[2]});
}

void TracedCallback::call(ros::SubscriptionCallbackHelperCallParams& params) {
  const trace::RecentMessages::Found found = trace::recent().find(params.event.getConstMessage().get());
  const std::uint64_t begin = trace::now();
  callback_->call(params);
  const trace::Arrow arrow = found.is_first_call ? trace::Arrow::ends : trace::Arrow::none;
  trace::record(trace::Step::callback, arrow, found.message, topic_, begin);
}

ros::SubscriptionCallbackHelperPtr traced(const ros::SubscriptionCallbackHelperPtr& callback,
                                          const std::string& resolved_topic) {
  if (!trace::active || !callback || &untraced(*callback) != callback.get()) return callback;
  return boost::make_shared<TracedCallback>(callback, resolved_topic);
}

const ros::SubscriptionCallbackHelper& untraced(const ros::SubscriptionCallbackHelper& callback) {
  const auto* const traced = dynamic_cast<const TracedCallback*>(&callback);
  return traced != nullptr ? traced->callback() : callback;
}

}  // namespace detail
}  // namespace tzc

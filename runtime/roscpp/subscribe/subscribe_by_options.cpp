// SPDX-License-Identifier: BSD-3-Clause
#include <ros/callback_queue_interface.h>
#include <tzc/subscribe.h>

#include "roscpp/subscribe/fault_ready_queue.h"
#include "roscpp/subscribe/waiting_end.h"
#include "roscpp/traces/traced_callback.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {

// The options get what roscpp itself writes into them, and nothing of TZC's: the user may subscribe with them again.
ros::Subscriber subscribe_by_options(ros::NodeHandle& node, ros::SubscribeOptions& options) {
  if (!options.callback_queue) options.callback_queue = node.getCallbackQueue();
  ros::SubscribeOptions prepared = options;
  prepared.callback_queue = fault_ready_queue(*options.callback_queue);
  if (trace::active) prepared.helper = traced(options.helper, node.resolveName(options.topic));
  const ros::Subscriber subscriber = with_waiting_end(node.subscribe(prepared), prepared);
  options.topic = prepared.topic;
  return subscriber;
}

}  // namespace detail
}  // namespace tzc

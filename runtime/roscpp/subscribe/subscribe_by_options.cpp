// SPDX-License-Identifier: BSD-3-Clause
#include <tzc/subscribe.h>

#include "roscpp/subscribe/waiting_end.h"
#include "roscpp/traces/traced_callback.h"
#include "trace/trace.h"

namespace tzc {
namespace detail {

// The options stay as the user made them: he may subscribe with them again.
ros::Subscriber subscribe_by_options(ros::NodeHandle& node, ros::SubscribeOptions& options) {
  const ros::SubscriptionCallbackHelperPtr callback = options.helper;
  if (trace::active) options.helper = traced(callback, node.resolveName(options.topic));
  const ros::Subscriber subscriber = with_waiting_end(node.subscribe(options), options);
  options.helper = callback;
  return subscriber;
}

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/subscribe_options.h>
#include <ros/subscriber.h>

namespace tzc {
namespace detail {

/// The subscriber of a direct callback; any other one as it is. Its last copy waits for a callback that runs on another thread, and
/// after it none begins. While the node shuts down roscpp does neither (TopicManager::unsubscribe): it relies on spinners, which end with
/// main(), and direct dispatch has none.
ros::Subscriber with_waiting_end(ros::Subscriber subscriber, const ros::SubscribeOptions& options);

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <message_filters/subscriber.h>
#include <tzc/ros.h>
namespace tzc {
namespace message_filters {
template <class M>
class Subscriber : public ::message_filters::Subscriber<M> {
  using ::message_filters::Subscriber<M>::Subscriber;
};
template <class M>
void subscribe(::message_filters::Subscriber<M>& filter, ros::NodeHandle& nh, const std::string& topic,
               uint32_t queue) {
  filter.subscribe(nh, topic, queue);
}
}  // namespace message_filters
}  // namespace tzc

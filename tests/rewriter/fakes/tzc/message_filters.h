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
}  // namespace message_filters
}  // namespace tzc

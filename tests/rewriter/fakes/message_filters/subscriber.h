// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
namespace message_filters {
template <class M>
class Subscriber {
 public:
  Subscriber() = default;
  Subscriber(ros::NodeHandle&, const std::string&, uint32_t) {}
  void subscribe(ros::NodeHandle&, const std::string&, uint32_t) {}
  void subscribe() {}
  void unsubscribe() {}
  template <class F>
  void registerCallback(F&&) {}
  template <class C, class T>
  void registerCallback(C&&, T*) {}
};
template <class A, class B>
class TimeSynchronizer {
 public:
  template <class F0, class F1>
  TimeSynchronizer(F0&, F1&, uint32_t) {}
  template <class F>
  void registerCallback(F&&) {}
  template <class C, class T>
  void registerCallback(C&&, T*) {}
};
}  // namespace message_filters

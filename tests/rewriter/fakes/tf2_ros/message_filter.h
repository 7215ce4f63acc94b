// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
namespace tf2_ros {
template <class M>
class MessageFilter {
 public:
  template <class F>
  MessageFilter(F&, const std::string&, uint32_t) {}
  template <class C>
  void registerCallback(const C&) {}
};
}  // namespace tf2_ros

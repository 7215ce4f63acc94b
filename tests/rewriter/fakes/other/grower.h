// SPDX-License-Identifier: BSD-3-Clause
// Code of another package that writes to what it is given as const, and some that does not.
#pragma once
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
namespace other {
template <class M>
void grow(const M& message) {
  const_cast<M&>(message).data.resize(5);
}
template <class M>
void grow_by_another(const M& message) {
  grow(message);
}
inline void pad(const sensor_msgs::ImageConstPtr& image) {
  boost::const_pointer_cast<sensor_msgs::Image>(image)->data.resize(5);
}
template <class M>
std::size_t size_of(const M& message) {
  return message.data.size() + *const_cast<unsigned char*>(message.data.data());
}
}  // namespace other

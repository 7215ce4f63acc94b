// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/ChannelFloat32.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct ChannelFloat32 {
  typedef ::sensor_msgs::ChannelFloat32 Stock;
  typedef boost::shared_ptr<ChannelFloat32> Ptr;
  typedef boost::shared_ptr<ChannelFloat32 const> ConstPtr;
  ChannelFloat32() = default;
  explicit ChannelFloat32(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, ChannelFloat32&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  std::string name;
  ::tzc::Array<float> values;
};
}  // namespace sensor_msgs
}  // namespace tzc

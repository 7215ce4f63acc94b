// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <ros/ros.h>
namespace rosbag {
class Bag {
 public:
  template <class M>
  void write(const std::string&, const ros::Time&, const M&) {}
  template <class M>
  void write(const std::string&, const ros::Time&, const boost::shared_ptr<M>&) {}
};
}  // namespace rosbag

// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = nh.advertise<sensor_msgs::Image>("image", 10, true);
/// After:   pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10, true);
const MethodCall advertise{
    "advertise", MethodCall::Role::advertise, "ros::NodeHandle", "advertise", "tzc::advertise", "tzc/ros.h"};

}  // namespace tzc::rewriter::rules

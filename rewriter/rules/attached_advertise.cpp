// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Of a publisher that stays what it is, because a library's object gets a copy of it, for example.
/// Before:  pub = nh.advertise<sensor_msgs::Image>("image", 10);
/// After:   pub = tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 10));
const AttachedAdvertise attached_advertise{"attached-advertise", "ros::Publisher", true, "tzc::attached",
                                           "tzc/ros.h"};

}  // namespace tzc::rewriter::rules

// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = advertise<sensor_msgs::Image>(nh, "image", 10);  // of a library's base class
/// After:   pub = tzc::attach_publisher<tzc::sensor_msgs::Image>(advertise<sensor_msgs::Image>(nh, "image",
/// 10), 0);
const LibraryAdvertise library_advertise{"library-advertise",     "ros::Publisher", "ros::NodeHandle", true,
                                         "tzc::attach_publisher", "tzc/ros.h"};

}  // namespace tzc::rewriter::rules

// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Of a publisher that code outside the package advertises.
/// Before:  map_pub_.publish(map);  // a member of a library's base class
/// After:   tzc::publish(map_pub_, map);
const MethodCall attached_publish{
    "attached-publish", MethodCall::Role::publish, "ros::Publisher", "publish", "tzc::publish", "tzc/ros.h"};

}  // namespace tzc::rewriter::rules

// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  sub = nh.subscribe("image", 1, &Viewer::on_image, this);
/// After:   sub = tzc::subscribe(nh, "image", 1, &Viewer::on_image, this);
const MethodCall subscribe{
    "subscribe", MethodCall::Role::subscribe, "ros::NodeHandle", "subscribe", "tzc::subscribe", "tzc/ros.h"};

}  // namespace tzc::rewriter::rules

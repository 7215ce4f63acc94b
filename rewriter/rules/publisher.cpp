// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  ros::Publisher pub;
/// After:   tzc::Publisher pub;
const ClassRename publisher{"publisher", ClassRename::Role::publisher, "ros::Publisher", "tzc::Publisher",
                            "tzc/ros.h"};

}  // namespace tzc::rewriter::rules

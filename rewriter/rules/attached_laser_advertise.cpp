// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  laser_pub_ = laser_proc::LaserTransport::advertiseLaser(nh, 20);
/// After:   laser_pub_ = tzc::laser_proc::attached(laser_proc::LaserTransport::advertiseLaser(nh, 20));
const LibraryTransport attached_laser_advertise{"attached-laser-advertise", "laser_proc::LaserPublisher",
                                                "sensor_msgs/MultiEchoLaserScan", "tzc::laser_proc::attached",
                                                "tzc/laser_proc.h"};

}  // namespace tzc::rewriter::rules

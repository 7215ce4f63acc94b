// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "run/child.h"

namespace tzc::compare {

/// A roscore of one's own.
class RosCore {
 public:
  /// Starts it at the environment's ROS_MASTER_URI and waits until it answers. @throws Failure, Stopped
  RosCore(const Environment& environment, const std::string& folder);
  void set_simulated_time();

 private:
  const Environment& environment_;
  const std::string folder_;
  Child child_;
};

}  // namespace tzc::compare

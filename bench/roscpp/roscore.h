// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include "loopback/reserved_port.h"

namespace tzc {
namespace bench {

/// A ROS master of the benchmark's own, on a free loopback port, for this process and the ones that it forks (it sets
/// ROS_MASTER_URI and ROS_IP, and takes away what else leads elsewhere). Stopped by pid.
class RosCore {
 public:
  RosCore();
  ~RosCore();
  bool running() const { return pid_ > 0; }

 private:
  const loopback::ReservedPort port_;
  pid_t pid_ = -1;
};

}  // namespace bench
}  // namespace tzc

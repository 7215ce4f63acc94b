// SPDX-License-Identifier: BSD-3-Clause
#include "run/roscore.h"

#include "loopback/reserved_port.h"
#include "run/failure.h"
#include "run/stop_request.h"

namespace tzc::compare {
namespace {

constexpr int start_steps = 300, start_step_ms = 100;

std::string port_of(const Environment& environment) {
  const std::string& uri = environment.at("ROS_MASTER_URI");
  return uri.substr(uri.rfind(':') + 1);
}

}  // namespace

RosCore::RosCore(const Environment& environment, const std::string& folder)
    : environment_(environment),
      folder_(folder),
      child_({"roscore", "-p", port_of(environment)}, environment, folder + "/roscore.log") {
  const int port = std::stoi(port_of(environment));
  for (int i = 0; i < start_steps; ++i) {
    if (loopback::is_listened_on(port)) return;
    if (!child_.is_running()) break;
    sleep_ms(start_step_ms);
  }
  throw Failure("roscore does not start:" + child_.log_tail());
}

void RosCore::set_simulated_time() {
  Child setter({"rosparam", "set", "/use_sim_time", "true"}, environment_, folder_ + "/rosparam.log");
  while (setter.is_running()) sleep_ms(start_step_ms);
  if (setter.status() != 0) throw Failure("/use_sim_time cannot be set:" + setter.log_tail());
}

}  // namespace tzc::compare

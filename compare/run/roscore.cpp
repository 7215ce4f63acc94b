// SPDX-License-Identifier: BSD-3-Clause
#include "run/roscore.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <random>

#include "run/failure.h"
#include "run/stop_request.h"

namespace tzc::compare {
namespace {

constexpr int start_steps = 300, start_step_ms = 100;

sockaddr_in loopback(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

template <class Function>
bool on_socket(int port, const Function& function) {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  const sockaddr_in address = loopback(port);
  const bool succeeded = function(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  ::close(fd);
  return succeeded;
}

std::string port_of(const Environment& environment) {
  const std::string& uri = environment.at("ROS_MASTER_URI");
  return uri.substr(uri.rfind(':') + 1);
}

}  // namespace

std::string RosCore::free_uri() {
  std::random_device dice;
  for (int i = 0; i < 1000; ++i) {
    const int port = static_cast<int>(15'000 + dice() % 17'000);
    if (on_socket(port, ::bind)) return "http://127.0.0.1:" + std::to_string(port);
  }
  throw Failure("no free port on the loopback interface");
}

RosCore::RosCore(const Environment& environment, const std::string& folder)
    : environment_(environment),
      folder_(folder),
      child_({"roscore", "-p", port_of(environment)}, environment, folder + "/roscore.log") {
  const int port = std::stoi(port_of(environment));
  for (int i = 0; i < start_steps; ++i) {
    if (on_socket(port, ::connect)) return;
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

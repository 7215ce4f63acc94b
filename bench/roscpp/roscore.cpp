// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/roscore.h"

#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <string>

#include "processes.h"

namespace tzc {
namespace bench {
namespace {

void run_master(const std::string& port) {
  const int null = ::open("/dev/null", O_RDWR);
  for (int fd = 0; fd < 3; ++fd) ::dup2(null, fd);
  ::execlp("rosmaster", "rosmaster", "--core", "-p", port.c_str(), static_cast<char*>(nullptr));
  ::_exit(127);
}

}  // namespace

RosCore::RosCore() {
  // For the user's own network: ROS_HOSTNAME counts before ROS_IP, and the names of nodes begin with ROS_NAMESPACE.
  for (const char* variable : {"ROS_HOSTNAME", "ROS_NAMESPACE", "ROS_IPV6"}) ::unsetenv(variable);
  const int port = port_.number();
  ::setenv("ROS_MASTER_URI", ("http://127.0.0.1:" + std::to_string(port)).c_str(), 1);
  ::setenv("ROS_IP", "127.0.0.1", 1);
  pid_ = in_child([port] { run_master(std::to_string(port)); });
  for (int i = 0; i < 2000; ++i) {
    if (loopback::is_listened_on(port)) return;
    if (!all_run({pid_})) break;
    ::usleep(10'000);
  }
  stop({pid_});
  pid_ = -1;
}

RosCore::~RosCore() {
  if (pid_ <= 0) return;
  ::kill(pid_, SIGTERM);
  ::waitpid(pid_, nullptr, 0);
}

}  // namespace bench
}  // namespace tzc

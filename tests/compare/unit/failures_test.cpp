// SPDX-License-Identifier: BSD-3-Clause
// What roslaunch says of nodes that have ended: the forms of Debian's roslaunch 1.15 and of Noetic's 1.16.
#include "run/failures.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <fstream>

namespace tzc::compare {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

std::set<std::string> died_by(const std::string& log) {
  const std::string path = testing::TempDir() + "roslaunch.log";
  std::ofstream(path) << log;
  return died_nodes(path);
}

TEST(failures, a_node_that_died_has_its_name_and_not_its_colour) {
  EXPECT_THAT(
      died_by("\x1b[31m[ns/camera-2] process has died [pid 41, exit code -11, cmd /opt/a __name:=camera].\n"
              "log file: /tmp/camera-2*.log\x1b[0m\n"),
      ElementsAre("ns/camera: exit code -11"));
}

TEST(failures, a_required_node_has_its_name_in_another_line) {
  EXPECT_THAT(died_by("\x1b[31m================REQUIRED process [camera-2] has died!\n"
                      "process has died [pid 41, exit code 3, cmd /opt/a].\n"
                      "log file: /tmp/camera-2*.log\nInitiating shutdown!\n================\x1b[0m\n"),
              ElementsAre("camera: exit code 3"));
}

TEST(failures, who_has_finished_cleanly_has_not_died) {
  EXPECT_THAT(died_by("[once-1] process has finished cleanly\nlog file: /tmp/once-1*.log\n"
                      "====REQUIRED process [camera-2] has died!\nprocess has finished cleanly\n"),
              IsEmpty());
}

TEST(failures, an_anonymous_node_has_the_same_name_in_each_run) {
  const auto first =
      died_by("[viewer_host_9518_2545678901234567890-3] process has died [pid 5, exit code 1, cmd a].\n");
  const auto second =
      died_by("[viewer_host_9601_1845678901234567890-3] process has died [pid 6, exit code 1, cmd a].\n");
  EXPECT_THAT(first, ElementsAre("viewer_host_*: exit code 1"));
  EXPECT_EQ(first, second);
}

TEST(failures, a_node_that_is_not_there) {
  EXPECT_THAT(died_by("\x1b[31mERROR: cannot launch node of type [my_pkg/my_node]: Cannot locate node of "
                      "type [my_node] in "
                      "package [my_pkg]. Make sure file exists in package path and permission is set to "
                      "executable\x1b[0m\n"),
              ElementsAre("my_pkg/my_node: cannot be launched"));
}

TEST(failures, a_line_of_any_length) {
  const std::string long_text(2'000'000, 'x');
  EXPECT_THAT(died_by("[" + long_text + "\n[camera-2] process has died [pid 4, exit code 1, cmd " +
                      long_text + "].\n[" + long_text + "-1] process has died [pid 5, exit code 2"),
              ElementsAre("camera: exit code 1", "camera: exit code 2"));
}

TEST(failures, no_log) {
  EXPECT_THAT(died_nodes("/nowhere/roslaunch.log"), IsEmpty());
}

}  // namespace
}  // namespace tzc::compare

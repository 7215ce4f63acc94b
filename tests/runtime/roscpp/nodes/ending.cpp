// SPDX-License-Identifier: BSD-3-Clause
/// A direct callback whose object goes while the node shuts down. Prints as JSON how often the callback ran in an object that was gone.
///
/// Private parameter: local (the messages come from this process; otherwise from a talker).
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <atomic>

#include "race.h"

namespace {

std::atomic<bool> is_gone{false};
std::atomic<int> calls{0}, calls_too_late{0};

struct Viewer {
  ros::Subscriber subscriber;

  void see(const sensor_msgs::ImageConstPtr&) {
    ++calls;
    ros::WallDuration(0.3).sleep();
    if (is_gone) ++calls_too_late;
  }
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "ending");
  const ros::NodeHandle options("~");
  ros::NodeHandle node;
  {
    Viewer viewer;
    viewer.subscriber = tzc::subscribe_direct(node, "image", 100, &Viewer::see, &viewer);
    tzc::Publisher publisher;
    if (options.param("local", false)) {
      publisher = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
      tzc_test::publish(publisher, 0, 10);
    }
    tzc_test::print_event("called", tzc_test::eventually([] { return calls > 0; }));
    ros::shutdown();
  }
  is_gone = true;
  const int calls_before = calls;
  ros::WallDuration(1).sleep();
  tzc_test::print_event("called too late", calls_too_late > 0);
  tzc_test::print_event("called afterwards", calls > calls_before);
}

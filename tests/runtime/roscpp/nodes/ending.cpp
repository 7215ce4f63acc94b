// SPDX-License-Identifier: BSD-3-Clause
/// A direct callback whose object goes while the node shuts down. Prints as JSON how often the callback ran in an object that was gone.
///
/// Private parameters: local (the messages come from this process; otherwise from a talker), concurrent (callbacks may run at once).
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

  void subscribe(ros::NodeHandle& node, bool concurrent) {
    const boost::function<void(const sensor_msgs::ImageConstPtr&)> callback =
        [this](const sensor_msgs::ImageConstPtr& image) { see(image); };
    ros::SubscribeOptions options = ros::SubscribeOptions::create<sensor_msgs::Image>(
        "image", 100, callback, ros::VoidConstPtr(), tzc::direct_dispatch_queue());
    options.allow_concurrent_callbacks = concurrent;
    subscriber = tzc::subscribe<sensor_msgs::Image>(node, options);
  }

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
    viewer.subscribe(node, options.param("concurrent", false));
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

// SPDX-License-Identifier: BSD-3-Clause
/// Keeps the first messages that it gets, destroys its subscriber in the very callback that brings the last
/// of them, and prints them afterwards.
///
/// Private parameters: keep (messages), outlive (a process ID: they are printed when it has ended), direct
/// (dispatch), shutdown (end the whole node in the callback: ros::shutdown), at_exit (it keeps them in a static object of the callback,
/// which calls exit() with the last of them; they are printed as that object is destroyed).
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <signal.h>
#include <sys/types.h>
#include <tzc/ros.h>

#include <atomic>
#include <cstdlib>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

/// Made in a callback, so exit() destroys it before it waits for the threads of the transport.
struct PrintedAtExit {
  std::vector<sensor_msgs::ImageConstPtr> kept;
  ~PrintedAtExit() {
    for (const sensor_msgs::ImageConstPtr& image : kept) tzc_test::print_image(*image);
  }
};

void exit_with(const sensor_msgs::ImageConstPtr& image, std::size_t wanted) {
  static PrintedAtExit at_exit;
  at_exit.kept.push_back(image);
  if (at_exit.kept.size() == wanted) std::exit(0);
}

struct Keeper {
  std::unique_ptr<ros::NodeHandle> node;
  ros::Subscriber subscriber;
  std::vector<sensor_msgs::ImageConstPtr> kept;
  std::size_t wanted = 0;
  std::mutex mutex;
  std::atomic<bool> is_full{false};
  bool shuts_down = false;
  bool exits = false;

  void subscribe(bool direct) {
    const std::lock_guard<std::mutex> lock(
        mutex);  // the first callback may come before there is a subscriber
    subscriber = direct ? tzc::subscribe_direct(*node, "image", 100, &Keeper::take, this)
                        : tzc::subscribe(*node, "image", 100, &Keeper::take, this);
  }

  void take(const sensor_msgs::ImageConstPtr& image) {
    if (exits) return exit_with(image, wanted);
    {
      const std::lock_guard<std::mutex> lock(mutex);  // direct dispatch calls on another thread
      if (kept.size() < wanted) kept.push_back(image);
      if (kept.size() < wanted || is_full) return;
    }
    if (shuts_down) ros::shutdown();
    subscriber = ros::Subscriber();
    is_full = true;
  }
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "keeper");
  Keeper keeper;
  ros::NodeHandle options("~");
  keeper.wanted = static_cast<std::size_t>(options.param("keep", 5));
  keeper.shuts_down = options.param("shutdown", false);
  keeper.exits = options.param("at_exit", false);
  const pid_t outlived = options.param("outlive", 0);
  keeper.node.reset(new ros::NodeHandle);
  keeper.subscribe(options.param("direct", false));
  while (!keeper.is_full && (ros::ok() || keeper.shuts_down))
    ros::getGlobalCallbackQueue()->callOne(ros::WallDuration(0.05));
  keeper.node.reset();
  while (outlived > 0 && kill(outlived, 0) == 0) ros::WallDuration(0.01).sleep();
  for (const sensor_msgs::ImageConstPtr& image : keeper.kept) tzc_test::print_image(*image);
}

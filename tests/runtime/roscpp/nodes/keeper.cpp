// SPDX-License-Identifier: BSD-3-Clause
/// Keeps the first messages that it gets, destroys its subscriber in the very callback that brings the last
/// of them, and prints them afterwards.
///
/// Private parameters: keep (messages), outlive (a process ID: they are printed when it has ended), direct
/// (dispatch), shutdown (end the whole node in the callback: ros::shutdown).
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <signal.h>
#include <sys/types.h>
#include <tzc/ros.h>

#include <atomic>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

struct Keeper {
  std::unique_ptr<ros::NodeHandle> node;
  ros::Subscriber subscriber;
  std::vector<sensor_msgs::ImageConstPtr> kept;
  std::size_t wanted = 0;
  std::mutex mutex;
  std::atomic<bool> is_full{false};
  bool shuts_down = false;

  void subscribe(bool direct) {
    const std::lock_guard<std::mutex> lock(
        mutex);  // the first callback may come before there is a subscriber
    subscriber = direct ? tzc::subscribe_direct(*node, "image", 100, &Keeper::take, this)
                        : tzc::subscribe(*node, "image", 100, &Keeper::take, this);
  }

  void take(const sensor_msgs::ImageConstPtr& image) {
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
  const pid_t outlived = options.param("outlive", 0);
  keeper.node.reset(new ros::NodeHandle);
  keeper.subscribe(options.param("direct", false));
  while (!keeper.is_full && (ros::ok() || keeper.shuts_down))
    ros::getGlobalCallbackQueue()->callOne(ros::WallDuration(0.05));
  keeper.node.reset();
  while (outlived > 0 && kill(outlived, 0) == 0) ros::WallDuration(0.01).sleep();
  for (const sensor_msgs::ImageConstPtr& image : keeper.kept) tzc_test::print_image(*image);
}

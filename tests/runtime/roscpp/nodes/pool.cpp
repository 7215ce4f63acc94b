// SPDX-License-Identifier: BSD-3-Clause
/// A callback lets a thread draw on its messages in place that another callback has started before anything was shared, as the pools of
/// OpenMP, TBB and OpenCV start theirs. Prints as JSON when so many were drawn on as the private parameter count says.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>

#include <condition_variable>
#include <mutex>
#include <thread>

#include "race.h"

namespace {

class Pool {
 public:
  void start() {
    std::thread([this] { work(); }).detach();
    const std::lock_guard<std::mutex> lock(mutex_);
    has_thread_ = true;
  }
  /// Returns when the thread has drawn.
  void draw(const sensor_msgs::ImageConstPtr& image) {
    std::unique_lock<std::mutex> lock(mutex_);
    if (!has_thread_) return;
    job_ = image;
    changed_.notify_all();
    changed_.wait(lock, [this] { return job_ == nullptr; });
  }
  int drawn() {
    const std::lock_guard<std::mutex> lock(mutex_);
    return drawn_;
  }

 private:
  void work() {
    for (std::unique_lock<std::mutex> lock(mutex_);;) {
      changed_.wait(lock, [this] { return job_ != nullptr; });
      const_cast<sensor_msgs::Image&>(*job_).data[0] ^= 1;
      job_.reset();
      ++drawn_;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  sensor_msgs::ImageConstPtr job_;
  bool has_thread_ = false;
  int drawn_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "pool");
  ros::NodeHandle node;
  const int count = ros::NodeHandle("~").param("count", 60);
  auto* const pool = new Pool;  // its thread never ends
  const ros::WallTimer timer = node.createWallTimer(
      ros::WallDuration(0.01), [pool](const ros::WallTimerEvent&) { pool->start(); }, true);
  const boost::function<void(const sensor_msgs::ImageConstPtr&)> callback =
      [pool](const sensor_msgs::ImageConstPtr& image) { pool->draw(image); };
  ros::Subscriber subscriber;
  ros::AsyncSpinner spinner(2);
  spinner.start();
  ros::WallDuration(0.5).sleep();  // the timer's callback comes first
  subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", 100, callback);
  tzc_test::print_event("drawn", tzc_test::eventually([&] { return pool->drawn() >= count; }));
  std::quick_exit(0);
}

// SPDX-License-Identifier: BSD-3-Clause
/// Subscribes to "image" and leaves again, over and over: each time is another upgrade. Prints a line of JSON
/// for each hop: how many messages, how many of them shared, the numbers that did not follow their
/// predecessor, those whose header.seq was another, and whether all bytes were right.
///
/// Private parameters: hops, shared (messages to see in shared memory before leaving), patience (seconds),
/// queue.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>

#include "pattern.h"

namespace {

class Hop {
 public:
  void see(const sensor_msgs::Image& image) {
    const int number = std::atoi(image.header.frame_id.c_str());
    if (count_++ > 0 && number != last_ + 1)
      jumps_ << (jumps_.tellp() > 0 ? ", " : "") << "[" << last_ << ", " << number << "]";
    last_ = number;
    shared_ += tzc::in_segment(image.data.data());
    const auto unsigned_number = static_cast<std::uint32_t>(number);
    right_ = right_ && tzc_test::has_pattern(image.data.data(), image.data.size(), unsigned_number);
    if (image.header.seq != unsigned_number)
      misnumbered_ << (misnumbered_.tellp() > 0 ? ", " : "") << "[" << number << ", " << image.header.seq
                   << "]";
  }
  int shared() const { return shared_; }
  void report() const {
    std::printf("{\"count\": %d, \"shared\": %d, \"right\": %s, \"jumps\": [%s], \"misnumbered\": [%s]}\n",
                count_, shared_, right_ ? "true" : "false", jumps_.str().c_str(), misnumbered_.str().c_str());
    std::fflush(stdout);
  }

 private:
  int count_ = 0, last_ = 0, shared_ = 0;
  bool right_ = true;
  std::ostringstream jumps_, misnumbered_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "hopper");
  ros::NodeHandle node, options("~");
  const int hops = options.param("hops", 100), shared = options.param("shared", 100);
  const int queue = options.param("queue", 10000);
  const ros::WallDuration patience(options.param("patience", 5.0));
  for (int i = 0; ros::ok() && i < hops; ++i) {
    Hop hop;
    const boost::function<void(const sensor_msgs::ImageConstPtr&)> see =
        [&hop](const sensor_msgs::ImageConstPtr& image) { hop.see(*image); };
    ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", queue, see);
    const ros::WallTime end = ros::WallTime::now() + patience;
    while (ros::ok() && hop.shared() < shared && ros::WallTime::now() < end)
      ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
    subscriber.shutdown();
    hop.report();
  }
}

// SPDX-License-Identifier: BSD-3-Clause
/// Subscribes to "image" and leaves again, over and over: each time is another upgrade. Prints a line of JSON
/// for each hop: how many messages, how many of them shared, how many after those came over TCPROS again, the
/// seconds in which they were published, the numbers that did not follow their predecessor, those whose
/// header.seq was another, and whether all bytes were right.
///
/// Private parameters: hops, shared (messages to see in shared memory before leaving), returned (messages to
/// see over TCPROS after that: the process runs out of descriptors, so that the next segment cannot be taken),
/// patience (seconds), queue.
#include <ros/callback_queue.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sys/resource.h>
#include <tzc/ros.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <string>
#include <vector>

#include "pattern.h"

namespace {

void limit_descriptors(rlim_t most) {
  rlimit limit{};
  getrlimit(RLIMIT_NOFILE, &limit);
  limit.rlim_cur = most;
  setrlimit(RLIMIT_NOFILE, &limit);
}

/// The process cannot open anything once it is filled.
class Hoard {
 public:
  /// Once more if another thread has closed something since.
  void fill() {
    for (int descriptor = dup(0); descriptor >= 0; descriptor = dup(0)) hoard_.push_back(descriptor);
  }
  ~Hoard() {
    for (const int descriptor : hoard_) close(descriptor);
  }

 private:
  std::vector<int> hoard_;
};

class Hop {
 public:
  void see(const sensor_msgs::Image& image) {
    const int number = std::atoi(image.header.frame_id.c_str());
    if (count_ == 0) begin_ = image.header.stamp;
    end_ = image.header.stamp;
    if (count_++ > 0 && number != last_ + 1)
      jumps_ << (jumps_.tellp() > 0 ? ", " : "") << "[" << last_ << ", " << number << "]";
    last_ = number;
    const bool is_shared = tzc::in_segment(image.data.data());
    shared_ += is_shared;
    returned_ = is_shared || shared_ == 0 ? 0 : returned_ + 1;
    const auto unsigned_number = static_cast<std::uint32_t>(number);
    right_ = right_ && tzc_test::has_pattern(image.data.data(), image.data.size(), unsigned_number);
    if (image.header.seq != unsigned_number)
      misnumbered_ << (misnumbered_.tellp() > 0 ? ", " : "") << "[" << number << ", " << image.header.seq
                   << "]";
  }
  int shared() const { return shared_; }
  int returned() const { return returned_; }
  void report() const {
    std::printf(
        "{\"count\": %d, \"shared\": %d, \"returned\": %d, \"seconds\": %.4f, \"right\": %s, \"jumps\": "
        "[%s], "
        "\"misnumbered\": [%s]}\n",
        count_, shared_, returned_, (end_ - begin_).toSec(), right_ ? "true" : "false", jumps_.str().c_str(),
        misnumbered_.str().c_str());
    std::fflush(stdout);
  }

 private:
  int count_ = 0, last_ = 0, shared_ = 0, returned_ = 0;
  ros::Time begin_, end_;
  bool right_ = true;
  std::ostringstream jumps_, misnumbered_;
};

/// Handles callbacks until the condition holds or the time is up.
template <class Condition>
void spin_until(const ros::WallTime& end, Condition holds) {
  while (ros::ok() && !holds() && ros::WallTime::now() < end)
    ros::getGlobalCallbackQueue()->callAvailable(ros::WallDuration(0.01));
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "hopper");
  ros::NodeHandle node, options("~");
  const int hops = options.param("hops", 100), shared = options.param("shared", 100);
  const int returned = options.param("returned", 0), queue = options.param("queue", 10000);
  const ros::WallDuration patience(options.param("patience", 5.0));
  limit_descriptors(1024);
  for (int i = 0; ros::ok() && i < hops; ++i) {
    Hop hop;
    const boost::function<void(const sensor_msgs::ImageConstPtr&)> see =
        [&hop](const sensor_msgs::ImageConstPtr& image) { hop.see(*image); };
    ros::Subscriber subscriber = tzc::subscribe<sensor_msgs::Image>(node, "image", queue, see);
    const ros::WallTime end = ros::WallTime::now() + patience;
    spin_until(end, [&] { return hop.shared() >= shared; });
    if (returned > 0) {
      Hoard hoard;
      spin_until(end, [&] {
        hoard.fill();
        return hop.returned() >= returned;
      });
    }
    subscriber.shutdown();
    hop.report();
  }
}

// SPDX-License-Identifier: BSD-3-Clause
/// Publishes images whose bytes follow from their number, in one of the ways a node may publish.
///
/// Private parameters: mode (twin, twin_pointer, stock, stock_pointer, plain), count, rate (Hz), bytes, latch,
/// subscribers (wait for so many), settle (seconds to wait then), linger (seconds to stay), queue, memory.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <string>

#include "pattern.h"

namespace {

template <class Image>
void fill(Image& image, std::uint32_t number, std::size_t bytes) {
  image.header.frame_id = std::to_string(number);
  image.height = 1;
  image.width = static_cast<std::uint32_t>(bytes);
  image.step = image.width;
  image.encoding = "mono8";
  image.data.resize(bytes);
  tzc_test::fill_pattern(image.data.data(), bytes, number);
  image.header.stamp = ros::Time::now();
}

class Talker {
 public:
  explicit Talker(ros::NodeHandle node, ros::NodeHandle options)
      : mode_(options.param<std::string>("mode", "twin")), bytes_(options.param("bytes", 100000)) {
    const int queue = options.param("queue", 10);
    const bool latch = options.param("latch", false);
    const int memory = options.param("memory", 0);
    if (mode_ == "plain")
      plain_ = node.advertise<sensor_msgs::Image>("image", queue, latch);
    else
      shared_ = tzc::advertise<tzc::sensor_msgs::Image>(node, "image", queue, memory, latch);
  }

  void publish(std::uint32_t number) {
    if (mode_ == "twin" || mode_ == "twin_pointer") return publish_twin(number);
    const auto image = boost::make_shared<sensor_msgs::Image>();
    fill(*image, number, bytes_);
    if (mode_ == "plain") return plain_.publish(*image);
    if (mode_ == "stock_pointer") return shared_.publish(image);
    shared_.publish(*image);
  }

  std::uint32_t subscribers() const {
    return mode_ == "plain" ? plain_.getNumSubscribers() : shared_.getNumSubscribers();
  }

  void report() const {
    const tzc::PublisherStatistics s = shared_.statistics();
    std::printf("{\"shared\": %llu, \"serialized\": %llu, \"copied_bytes\": %llu, \"exhausted\": %llu}\n",
                (unsigned long long)s.shared, (unsigned long long)s.serialized, (unsigned long long)s.copied_bytes,
                (unsigned long long)s.exhausted);
    std::fflush(stdout);
  }

 private:
  void publish_twin(std::uint32_t number) {
    const auto image = boost::make_shared<tzc::sensor_msgs::Image>();
    shared_.allocate(*image);
    fill(*image, number, bytes_);
    if (mode_ == "twin_pointer")
      shared_.publish(image);
    else
      shared_.publish(*image);
  }

  std::string mode_;
  std::size_t bytes_;
  ros::Publisher plain_;
  tzc::Publisher shared_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "talker");
  ros::NodeHandle node, options("~");
  Talker talker(node, options);
  const auto wanted = static_cast<std::uint32_t>(options.param("subscribers", 1));
  while (ros::ok() && talker.subscribers() < wanted) ros::WallDuration(0.002).sleep();
  ros::WallDuration(options.param("settle", 0.0)).sleep();
  ros::WallRate rate(options.param("rate", 100.0));
  const int count = options.param("count", 100);
  for (int number = 0; ros::ok() && (count == 0 || number < count); ++number) {
    talker.publish(static_cast<std::uint32_t>(number));
    rate.sleep();
  }
  ros::WallDuration(options.param("linger", 1.0)).sleep();
  talker.report();
}

// SPDX-License-Identifier: BSD-3-Clause
/// A laser scanner whose publisher advertises and publishes by itself, as that of laser_proc, or what listens to it; lines as in
/// image_line.h.
///
/// Private parameters: role (scanner, listener). Scanner: count, pointer (publish by pointer). Listener: its lines tell the topic.
#include <ros/ros.h>
#include <tzc/laser_proc.h>
#include <tzc/memory.h>
#include <tzc/ros.h>

#include <cstdio>
#include <string>
#include <vector>

namespace {

constexpr std::size_t beams = 20000, beams_with_echoes = 1000;

float range_of(std::uint32_t number, std::size_t beam) {
  return static_cast<float>(number) + static_cast<float>(beam % 100) / 100;
}

class LaserPublisher {
 public:
  LaserPublisher() {}
  explicit LaserPublisher(ros::NodeHandle& node)
      : echoes_(node.advertise<sensor_msgs::MultiEchoLaserScan>("echoes", 100)),
        first_(node.advertise<sensor_msgs::LaserScan>("first", 100)) {}

  explicit operator bool() const { return first_; }
  std::vector<std::string> getTopics() const { return {echoes_.getTopic(), first_.getTopic()}; }
  std::uint32_t subscribers() const { return first_.getNumSubscribers(); }

  void publish(std::uint32_t number, bool by_pointer) const {
    const auto scan = boost::make_shared<sensor_msgs::MultiEchoLaserScan>();
    scan->header.frame_id = std::to_string(number);
    scan->ranges.resize(beams_with_echoes);
    for (std::size_t i = 0; i < beams_with_echoes; ++i) scan->ranges[i].echoes.push_back(range_of(number, i));
    const auto first = boost::make_shared<sensor_msgs::LaserScan>();
    first->header = scan->header;
    for (std::size_t i = 0; i < beams; ++i) first->ranges.push_back(range_of(number, i));
    if (by_pointer) {
      echoes_.publish(scan);
      first_.publish(first);
    } else {
      echoes_.publish(*scan);
      first_.publish(*first);
    }
  }

 private:
  ros::Publisher echoes_, first_;
};

void scan(ros::NodeHandle& node, const ros::NodeHandle& options) {
  tzc::laser_proc::attached(LaserPublisher());  // attaches nothing
  const LaserPublisher publisher = tzc::laser_proc::attached(LaserPublisher(node));
  while (ros::ok() && publisher.subscribers() == 0) ros::WallDuration(0.01).sleep();
  ros::WallDuration(1.0).sleep();
  for (int number = 0; ros::ok() && number < options.param("count", 20); ++number) {
    publisher.publish(static_cast<std::uint32_t>(number), options.param("pointer", false));
    ros::WallDuration(0.02).sleep();
  }
  ros::WallDuration(0.5).sleep();
}

void print(const char* topic, const std_msgs::Header& header, bool right, bool shared) {
  std::printf("{\"topic\": \"%s\", \"number\": %s, \"seq\": %u, \"right\": %s, \"shared\": %s}\n", topic,
              header.frame_id.c_str(), header.seq, right ? "true" : "false", shared ? "true" : "false");
  std::fflush(stdout);
}

template <class RangeOf>
bool is_right(const std_msgs::Header& header, std::size_t size, std::size_t wanted, RangeOf range) {
  const auto number = static_cast<std::uint32_t>(std::stoul(header.frame_id));
  for (std::size_t i = 0; i < size; ++i)
    if (range(i) != range_of(number, i)) return false;
  return size == wanted;
}

void listen(ros::NodeHandle& node) {
  const boost::function<void(const sensor_msgs::LaserScanConstPtr&)> take_first =
      [](const sensor_msgs::LaserScanConstPtr& scan) {
        print("first", scan->header,
              is_right(scan->header, scan->ranges.size(), beams,
                       [&](std::size_t i) { return scan->ranges[i]; }),
              tzc::in_segment(scan->ranges.data()));
      };
  const boost::function<void(const sensor_msgs::MultiEchoLaserScanConstPtr&)> take_echoes =
      [](const sensor_msgs::MultiEchoLaserScanConstPtr& scan) {
        const auto echo = [&](std::size_t i) { return scan->ranges[i].echoes.at(0); };
        print("echoes", scan->header, is_right(scan->header, scan->ranges.size(), beams_with_echoes, echo),
              false);
      };
  const ros::Subscriber echoes =
      tzc::subscribe<sensor_msgs::MultiEchoLaserScan>(node, "echoes", 100, take_echoes);
  const ros::Subscriber first = tzc::subscribe<sensor_msgs::LaserScan>(node, "first", 100, take_first);
  ros::spin();
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "scanner");
  ros::NodeHandle node, options("~");
  if (options.param<std::string>("role", "scanner") == "listener")
    listen(node);
  else
    scan(node, options);
}

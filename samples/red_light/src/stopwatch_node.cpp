// SPDX-License-Identifier: BSD-3-Clause
#include <red_light/Detection.h>
#include <red_light/Stop.h>
#include <ros/ros.h>

#include <algorithm>
#include <fstream>
#include <string>
#include <vector>

namespace red_light {

/// Writes a line about each stop: the moments, in seconds since the robot crossed the line, and the distance.
///
/// Private parameters: csv (the file), stops (after so many it ends; 0: never).
class StopwatchNode {
 public:
  StopwatchNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
      : stops_(private_nh.param("stops", 0)),
        csv_(private_nh.param<std::string>("csv", "stops.csv").c_str()) {
    csv_ << "published,received,detected,braking,standstill,speed,distance\n" << std::flush;
    csv_.precision(9);
    red_ = nh.subscribe("light/red", 100, &StopwatchNode::onRed, this);
    stop_ = nh.subscribe("stop", 10, &StopwatchNode::onStop, this);
  }

 private:
  void onRed(const Detection& detection) { seen_.push_back(detection); }

  /// The first red light behind the line is the one that the robot braked for.
  void onStop(const Stop& stop) {
    const auto cause = std::find_if(seen_.begin(), seen_.end(), [&stop](const Detection& detection) {
      return detection.header.stamp > stop.crossing;
    });
    if (cause == seen_.end() || cause->detected > stop.braking)
      ROS_WARN("the robot stopped without having seen a red light behind the line");
    else
      write(*cause, stop);
    seen_.clear();
  }

  void write(const Detection& cause, const Stop& stop) {
    for (const ros::Time& moment :
         {cause.header.stamp, cause.received, cause.detected, stop.braking, stop.standstill})
      csv_ << (moment - stop.crossing).toSec() << ',';
    csv_ << stop.speed << ',' << stop.distance << std::endl;
    if (++written_ == stops_) ros::shutdown();
  }

  int stops_, written_ = 0;
  std::ofstream csv_;
  std::vector<Detection> seen_;
  ros::Subscriber red_, stop_;
};

}  // namespace red_light

int main(int argc, char** argv) {
  ros::init(argc, argv, "stopwatch_node");
  red_light::StopwatchNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

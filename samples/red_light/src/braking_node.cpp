// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/Twist.h>
#include <red_light/Detection.h>
#include <ros/ros.h>

namespace red_light {

/// Drives at green and stops at red.
///
/// Private parameters: speed (m/s, or rad/s with turns), turns (turn on the spot instead of driving ahead).
class BrakingNode {
 public:
  BrakingNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
      : speed_(private_nh.param("speed", 0.6)), turns_(private_nh.param("turns", false)) {
    const ros::TransportHints hints = ros::TransportHints().tcpNoDelay();
    velocity_ = nh.advertise<geometry_msgs::Twist>("cmd_vel", 1);
    green_ = nh.subscribe("light/green", 1, &BrakingNode::onGreen, this, hints);
    yellow_ = nh.subscribe("light/yellow", 1, &BrakingNode::onYellow, this, hints);
    red_ = nh.subscribe("light/red", 1, &BrakingNode::onRed, this, hints);
  }

 private:
  void onGreen(const Detection&) { command(speed_); }
  void onYellow(const Detection&) { ROS_INFO_THROTTLE(1.0, "yellow: red may follow"); }
  void onRed(const Detection&) { command(0); }

  void command(double speed) {
    geometry_msgs::Twist velocity;
    (turns_ ? velocity.angular.z : velocity.linear.x) = speed;
    velocity_.publish(velocity);
  }

  double speed_;
  bool turns_;
  ros::Publisher velocity_;
  ros::Subscriber green_, yellow_, red_;
};

}  // namespace red_light

int main(int argc, char** argv) {
  ros::init(argc, argv, "braking_node");
  red_light::BrakingNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

// SPDX-License-Identifier: BSD-3-Clause
#include <geometry_msgs/Twist.h>
#include <nav_msgs/Odometry.h>
#include <red_light/Stop.h>
#include <ros/ros.h>

#include <algorithm>
#include <cmath>

namespace red_light {

/// A simulated TurtleBot2 that drives along a line or turns on the spot, in formulas instead of steps of time.
///
/// A command to move makes it depart from `run_up` before the line, at the next moment that lets it cross the line
/// `phase` of a camera period after the camera took an image: two runs with the same phase differ in nothing else. A
/// command to stop makes it brake with `deceleration`. A second after standstill it is put back to where it departed.
class RobotNode {
 public:
  RobotNode(ros::NodeHandle nh, ros::NodeHandle private_nh) {
    private_nh.param("turns", turns_, false);
    // The TurtleBot2's velocity smoother: acceleration 1 m/s2 and 2 rad/s2, times 1.5 when it slows down.
    private_nh.param("deceleration", deceleration_, turns_ ? 3.0 : 1.5);
    private_nh.param("line", line_, 0.0);
    private_nh.param("run_up", run_up_, 0.6);
    private_nh.param("camera_period", camera_period_, 1.0 / 30);
    private_nh.param("phase", phase_, 0.5);
    odometry_ = nh.advertise<nav_msgs::Odometry>("odom", 1);
    stops_ = nh.advertise<Stop>("stop", 10);
    command_ = nh.subscribe("cmd_vel", 1, &RobotNode::onCommand, this, ros::TransportHints().tcpNoDelay());
    clock_ = nh.createTimer(ros::Duration(0.02), &RobotNode::onClock, this);
  }

 private:
  enum class State { WAITING, MOVING, BRAKING, STANDING };

  void onCommand(const geometry_msgs::Twist& velocity) {
    const double speed = turns_ ? velocity.angular.z : velocity.linear.x;
    if (speed > 0 && state_ == State::WAITING) depart(speed);
    if (speed == 0 && state_ == State::MOVING) brake(ros::Time::now());
  }

  void depart(double speed) {
    const double earliest = ros::Time::now().toSec() + run_up_ / speed;
    stop_.crossing = ros::Time((std::ceil(earliest / camera_period_) + phase_) * camera_period_);
    stop_.speed = speed;
    state_ = State::MOVING;
  }

  void brake(const ros::Time& now) {
    stop_.braking = now;
    stop_.standstill = now + ros::Duration(stop_.speed / deceleration_);
    stop_.distance = position(stop_.standstill, State::BRAKING) - line_;
    state_ = State::BRAKING;
  }

  void onClock(const ros::TimerEvent&) {
    const ros::Time now = ros::Time::now();
    publishOdometry(now);
    if (state_ == State::BRAKING && now >= stop_.standstill) announce();
    if (state_ == State::STANDING && now >= stop_.standstill + ros::Duration(1.0)) state_ = State::WAITING;
  }

  void announce() {
    state_ = State::STANDING;
    stops_.publish(stop_);
    ROS_INFO("stopped %.4f %s behind the line", stop_.distance, turns_ ? "rad" : "m");
  }

  double position(const ros::Time& at, State state) const {
    if (state == State::WAITING) return line_ - run_up_;
    const double ahead = stop_.speed * (at - stop_.crossing).toSec();
    if (state == State::MOVING) return line_ + std::max(ahead, -run_up_);
    const double slowing = (std::min(at, stop_.standstill) - stop_.braking).toSec();
    const double moving = (stop_.braking - stop_.crossing).toSec();
    return line_ + stop_.speed * (moving + slowing) - deceleration_ * slowing * slowing / 2;
  }

  double speed(const ros::Time& at) const {
    if (state_ == State::MOVING) return position(at, state_) > line_ - run_up_ ? stop_.speed : 0;
    if (state_ == State::BRAKING) return std::max(0.0, deceleration_ * (stop_.standstill - at).toSec());
    return 0;
  }

  void publishOdometry(const ros::Time& now) {
    nav_msgs::Odometry odometry;
    odometry.header.stamp = now;
    odometry.header.frame_id = "odom";
    odometry.child_frame_id = "base_footprint";
    const double at = position(now, state_);
    odometry.pose.pose.position.x = turns_ ? 0 : at;
    odometry.pose.pose.orientation.z = turns_ ? std::sin(at / 2) : 0;
    odometry.pose.pose.orientation.w = turns_ ? std::cos(at / 2) : 1;
    (turns_ ? odometry.twist.twist.angular.z : odometry.twist.twist.linear.x) = speed(now);
    odometry_.publish(odometry);
  }

  bool turns_;
  double deceleration_, line_, run_up_, camera_period_, phase_;
  State state_ = State::WAITING;
  Stop stop_;
  ros::Publisher odometry_, stops_;
  ros::Subscriber command_;
  ros::Timer clock_;
};

}  // namespace red_light

int main(int argc, char** argv) {
  ros::init(argc, argv, "robot_node");
  red_light::RobotNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

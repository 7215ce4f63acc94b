// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace camera_pair {

/// Publishes a moving colour gradient as rgb8 images on "camera/image".
///
/// Private parameters: width, height (pixels), rate (Hz), count (frames, 0 = until shutdown),
/// subscribers (wait for that many before the first frame).
class CameraNode {
 public:
  CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh);

 private:
  void onTimer(const ros::TimerEvent& event);
  void onDone(const ros::TimerEvent& event);
  void publishFrame();

  ros::NodeHandle nh_;
  ros::Publisher publisher_;
  ros::Timer timer_;
  ros::Timer done_timer_;

  int width_;
  int height_;
  int count_;
  int wanted_subscribers_;
  int frame_ = 0;
};

}  // namespace camera_pair

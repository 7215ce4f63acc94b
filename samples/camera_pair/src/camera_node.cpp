// SPDX-License-Identifier: BSD-3-Clause
#include "camera_node.h"

namespace camera_pair {

CameraNode::CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh) : nh_(nh) {
  const double rate = private_nh.param("rate", 30.0);
  private_nh.param("width", width_, 1920);
  private_nh.param("height", height_, 1080);
  private_nh.param("count", count_, 0);
  private_nh.param("subscribers", wanted_subscribers_, 0);

  publisher_ = nh_.advertise<sensor_msgs::Image>("camera/image", 10);
  timer_ = nh_.createTimer(ros::Duration(1.0 / rate), &CameraNode::onTimer, this);
}

void CameraNode::onTimer(const ros::TimerEvent&) {
  if (frame_ == 0 && static_cast<int>(publisher_.getNumSubscribers()) < wanted_subscribers_) return;
  publishFrame();
  ++frame_;
  if (count_ == 0 || frame_ < count_) return;

  timer_.stop();
  // Slow subscribers still get what is queued.
  done_timer_ = nh_.createTimer(ros::Duration(1.0), &CameraNode::onDone, this, true);
}

void CameraNode::onDone(const ros::TimerEvent&) {
  ROS_INFO("published %d frames", frame_);
  ros::shutdown();
}

void CameraNode::publishFrame() {
  sensor_msgs::Image image;
  image.header.frame_id = "camera";
  image.width = width_;
  image.height = height_;
  image.encoding = "rgb8";
  image.is_bigendian = false;
  image.step = 3 * image.width;
  image.data.resize(image.step * image.height);

  for (unsigned y = 0; y < image.height; ++y) {
    uint8_t* row = &image.data[y * image.step];
    for (unsigned x = 0; x < image.width; ++x) {
      row[3 * x + 0] = x + frame_;
      row[3 * x + 1] = y + 2 * frame_;
      row[3 * x + 2] = 3 * frame_;
    }
  }

  image.header.stamp = ros::Time::now();
  publisher_.publish(image);
}

}  // namespace camera_pair

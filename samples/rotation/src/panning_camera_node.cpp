// SPDX-License-Identifier: BSD-3-Clause
#include <nav_msgs/Odometry.h>
#include <red_light/lamp.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <cmath>

namespace rotation {

/// A camera on a robot that turns to the left in front of three traffic lights: green, yellow, red.
///
/// Takes an image whenever the clock is a multiple of 1/rate, as a camera does that is triggered from outside.
/// The image's stamp is the moment just before it is published.
class PanningCameraNode {
 public:
  PanningCameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
      : period_(1.0 / private_nh.param("rate", 30.0)) {
    private_nh.param("width", width_, 1920);
    private_nh.param("height", height_, 1080);
    pixels_per_radian_ = 0.866 * width_;
    drawPanorama(private_nh);
    publisher_ = nh.advertise<sensor_msgs::Image>("camera/image", 2);
    odometry_ =
        nh.subscribe("odom", 1, &PanningCameraNode::onOdometry, this, ros::TransportHints().tcpNoDelay());
  }

  void spin() {
    while (ros::ok()) {
      const double now = ros::Time::now().toSec();
      ros::Time::sleepUntil(ros::Time((std::floor(now / period_) + 1) * period_));
      ros::spinOnce();
      if (!robot_.header.stamp.isZero()) takeImage(heading(ros::Time::now()));
    }
  }

 private:
  void onOdometry(const nav_msgs::Odometry& odometry) { robot_ = odometry; }

  /// Three views wide; heading 0 looks at its middle.
  void drawPanorama(ros::NodeHandle& private_nh) {
    panorama_ = red_light::drawStreet(3 * width_, height_);
    const int lamp_radius = static_cast<int>(0.1 * pixels_per_radian_ / 10);      // 10 cm, 10 m away
    const int y = height_ / 2 - static_cast<int>(1.5 * pixels_per_radian_ / 10);  // 1.5 m above the camera
    for (const char* colour : {"green", "yellow", "red"}) {
      const double bearing = private_nh.param(std::string(colour), 0.0);
      const int x = 3 * width_ / 2 - static_cast<int>(bearing * pixels_per_radian_);
      red_light::drawTrafficLight(panorama_, cv::Point(x, y), lamp_radius, colour);
    }
  }

  /// Radians to the left, within half a turn: the latest odometry, continued to this moment.
  double heading(const ros::Time& at) const {
    const geometry_msgs::Quaternion& q = robot_.pose.pose.orientation;
    const double since = (at - robot_.header.stamp).toSec();
    return std::remainder(2 * std::atan2(q.z, q.w) + robot_.twist.twist.angular.z * since, 2 * M_PI);
  }

  void takeImage(double heading) {
    sensor_msgs::Image image;
    image.header.frame_id = "camera";
    image.width = width_;
    image.height = height_;
    image.encoding = "bgr8";
    image.is_bigendian = false;
    image.step = 3 * image.width;
    image.data.resize(image.step * image.height);

    const int left = width_ - static_cast<int>(std::lround(heading * pixels_per_radian_));
    const cv::Rect view(std::min(std::max(left, 0), 2 * width_), 0, width_, height_);
    cv::Mat pixels(height_, width_, CV_8UC3, image.data.data(), image.step);
    panorama_(view).copyTo(pixels);

    image.header.stamp = ros::Time::now();
    publisher_.publish(image);
  }

  double period_, pixels_per_radian_;
  int width_, height_;
  cv::Mat panorama_;
  nav_msgs::Odometry robot_;
  ros::Publisher publisher_;
  ros::Subscriber odometry_;
};

}  // namespace rotation

int main(int argc, char** argv) {
  ros::init(argc, argv, "panning_camera_node");
  rotation::PanningCameraNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  node.spin();
}

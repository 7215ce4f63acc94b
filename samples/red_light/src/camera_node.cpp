// SPDX-License-Identifier: BSD-3-Clause
#include <nav_msgs/Odometry.h>
#include <red_light/lamp.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <cmath>

namespace red_light {

/// A camera on a robot that drives towards a traffic light: green, yellow near the line, red from the line on.
///
/// Takes an image whenever the clock is a multiple of 1/rate, as a camera does that is triggered from outside.
/// The image's stamp is the moment just before it is published.
class CameraNode {
 public:
  CameraNode(ros::NodeHandle nh, ros::NodeHandle private_nh) : period_(1.0 / private_nh.param("rate", 30.0)) {
    private_nh.param("line", line_, 0.0);
    private_nh.param("yellow", yellow_, 0.3);
    private_nh.param("light_distance", light_distance_, 10.0);
    street_ = drawStreet(private_nh.param("width", 1920), private_nh.param("height", 1080));
    focal_length_ = 0.866 * street_.cols;  // 60 degrees of view
    publisher_ = nh.advertise<sensor_msgs::Image>("camera/image", 2);
    odometry_ = nh.subscribe("odom", 1, &CameraNode::onOdometry, this, ros::TransportHints().tcpNoDelay());
  }

  void spin() {
    while (ros::ok()) {
      const double now = ros::Time::now().toSec();
      ros::Time::sleepUntil(ros::Time((std::floor(now / period_) + 1) * period_));
      ros::spinOnce();
      takeImage(position(ros::Time::now()));
    }
  }

 private:
  void onOdometry(const nav_msgs::Odometry& odometry) { robot_ = odometry; }

  /// Along the street, metres: the latest odometry, continued to this moment.
  double position(const ros::Time& at) const {
    if (robot_.header.stamp.isZero()) return line_ - 1;
    return robot_.pose.pose.position.x + robot_.twist.twist.linear.x * (at - robot_.header.stamp).toSec();
  }

  std::string lit(double position) const {
    if (position >= line_) return "red";
    return position >= line_ - yellow_ ? "yellow" : "green";
  }

  void takeImage(double position) {
    sensor_msgs::Image image;
    image.header.frame_id = "camera";
    image.width = street_.cols;
    image.height = street_.rows;
    image.encoding = "bgr8";
    image.is_bigendian = false;
    image.step = 3 * image.width;
    image.data.resize(image.step * image.height);

    cv::Mat pixels(street_.rows, street_.cols, CV_8UC3, image.data.data(), image.step);
    street_.copyTo(pixels);
    drawLight(pixels, position);

    image.header.stamp = ros::Time::now();
    publisher_.publish(image);
  }

  /// A light with lamps of 20 cm, its middle 1.5 m above the camera.
  void drawLight(cv::Mat& pixels, double position) const {
    const double scale = focal_length_ / (line_ + light_distance_ - position);  // pixels per metre
    const cv::Point centre(street_.cols / 2, street_.rows / 2 - static_cast<int>(1.5 * scale));
    drawTrafficLight(pixels, centre, static_cast<int>(0.1 * scale), lit(position));
  }

  double period_, line_, yellow_, light_distance_, focal_length_;
  cv::Mat street_;
  nav_msgs::Odometry robot_;
  ros::Publisher publisher_;
  ros::Subscriber odometry_;
};

}  // namespace red_light

int main(int argc, char** argv) {
  ros::init(argc, argv, "camera_node");
  red_light::CameraNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  node.spin();
}

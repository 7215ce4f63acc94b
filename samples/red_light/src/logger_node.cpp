// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <string>

namespace red_light {

/// Looks at every image and keeps a line about it: when it was published and received, and how bright it is.
///
/// Private parameter csv: the file.
class LoggerNode {
 public:
  LoggerNode(ros::NodeHandle nh, ros::NodeHandle private_nh)
      : log_(private_nh.param<std::string>("csv", "images.csv").c_str()) {
    log_ << "published,received,brightness\n";
    subscriber_ = nh.subscribe("camera/image", 2, &LoggerNode::onImage, this);
  }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image) {
    const ros::Time received = ros::Time::now();
    const cv::Scalar mean = cv::mean(cv_bridge::toCvShare(image)->image);
    log_ << image->header.stamp << ',' << received << ',' << (mean[0] + mean[1] + mean[2]) / 3 << '\n';
  }

  std::ofstream log_;
  ros::Subscriber subscriber_;
};

}  // namespace red_light

int main(int argc, char** argv) {
  ros::init(argc, argv, "logger_node");
  red_light::LoggerNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <red_light/Detection.h>
#include <red_light/lamp.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <string>

namespace red_light {

/// Looks for a lit lamp of one colour in a region of each image, and publishes what it finds on light/<colour>.
class DetectorNode {
 public:
  DetectorNode(ros::NodeHandle nh, ros::NodeHandle private_nh) {
    const std::string colour = private_nh.param<std::string>("colour", "red");
    private_nh.param("threshold", threshold_, 0.85);
    region_ = cv::Rect(private_nh.param("region_x", 880), private_nh.param("region_y", 210),
                       private_nh.param("region_width", 160), private_nh.param("region_height", 160));
    lamp_ = makeTemplate(private_nh.param("radius", 16), lampColour(colour));
    publisher_ = nh.advertise<Detection>("light/" + colour, 2);
    subscriber_ = nh.subscribe("camera/image", 1, &DetectorNode::onImage, this);
  }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image) {
    Detection detection;
    detection.received = ros::Time::now();
    detection.header = image->header;

    const cv_bridge::CvImageConstPtr shared = cv_bridge::toCvShare(image, "bgr8");
    cv::Mat scores;
    cv::matchTemplate(shared->image(region_), lamp_, scores, cv::TM_CCOEFF_NORMED);
    double score = 0;
    cv::Point place;
    cv::minMaxLoc(scores, nullptr, &score, nullptr, &place);
    if (score < threshold_) return;

    detection.x = region_.x + place.x;
    detection.y = region_.y + place.y;
    detection.score = static_cast<float>(score);
    detection.detected = ros::Time::now();
    publisher_.publish(detection);
  }

  double threshold_;
  cv::Rect region_;
  cv::Mat lamp_;
  ros::Publisher publisher_;
  ros::Subscriber subscriber_;
};

}  // namespace red_light

int main(int argc, char** argv) {
  ros::init(argc, argv, "detector_node");
  red_light::DetectorNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

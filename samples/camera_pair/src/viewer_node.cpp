// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <fstream>
#include <opencv2/core.hpp>
#include <string>

namespace camera_pair {

/// Looks at the centre of every image and reports its brightness.
///
/// Private parameter csv: a file that gets one line per image, for measurements.
class ViewerNode {
 public:
  ViewerNode(ros::NodeHandle nh, ros::NodeHandle private_nh) {
    const std::string csv = private_nh.param<std::string>("csv", "");
    if (!csv.empty()) {
      csv_.open(csv.c_str());
      csv_ << "seq,latency_us,address,size\n";
    }
    subscriber_ = nh.subscribe("camera/image", 10, &ViewerNode::onImage, this);
  }

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image) {
    const ros::WallTime arrival = ros::WallTime::now();
    if (csv_.is_open()) record(*image, arrival);

    const cv_bridge::CvImageConstPtr shared = cv_bridge::toCvShare(image);
    const cv::Rect whole(0, 0, shared->image.cols, shared->image.rows);
    const cv::Rect centre = whole & cv::Rect(whole.width / 2 - 32, whole.height / 2 - 32, 64, 64);
    const cv::Scalar mean = cv::mean(shared->image(centre));
    ROS_INFO_THROTTLE(1.0, "brightness %.1f", (mean[0] + mean[1] + mean[2]) / 3);
  }

  void record(const sensor_msgs::Image& image, const ros::WallTime& arrival) {
    const ros::WallTime stamp(image.header.stamp.sec, image.header.stamp.nsec);
    csv_ << image.header.seq << ',' << (arrival - stamp).toSec() * 1e6 << ','
         << static_cast<const void*>(image.data.data()) << ',' << image.data.size() << '\n';
  }

  ros::Subscriber subscriber_;
  std::ofstream csv_;
};

}  // namespace camera_pair

int main(int argc, char** argv) {
  ros::init(argc, argv, "viewer_node", ros::init_options::AnonymousName);
  camera_pair::ViewerNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

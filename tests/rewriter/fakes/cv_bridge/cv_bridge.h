// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/Image.h>
#define CV_8UC3 16
namespace cv {
struct Mat {
  Mat() = default;
  Mat(int, int, int) {}
  Mat(int, int, int, void*, std::size_t = 0) {}
  Mat clone() const { return {}; }
  void copyTo(Mat) const {}
  Mat operator()(int) const { return {}; }
  unsigned char* data = nullptr;
  int rows = 0, cols = 0;
};
inline void flip(const Mat&, Mat, int) {}
}  // namespace cv
namespace cv_bridge {
class CvImage {
 public:
  typedef boost::shared_ptr<CvImage> Ptr;
  CvImage() = default;
  CvImage(const std_msgs::Header&, const std::string&, const cv::Mat& = cv::Mat()) {}
  sensor_msgs::ImagePtr toImageMsg() const { return {}; }
  void toImageMsg(sensor_msgs::Image&) const {}
  std_msgs::Header header;
  std::string encoding;
  cv::Mat image;
};
typedef boost::shared_ptr<CvImage> CvImagePtr;
typedef boost::shared_ptr<CvImage const> CvImageConstPtr;
inline CvImageConstPtr toCvShare(const sensor_msgs::ImageConstPtr&, const std::string& = "") { return {}; }
inline CvImagePtr toCvCopy(const sensor_msgs::ImageConstPtr&, const std::string& = "") { return {}; }
}  // namespace cv_bridge

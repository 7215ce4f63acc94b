// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/Image.h>
#define CV_8UC3 16
namespace cv {
struct Scalar {
  Scalar(int) {}
};
template <class T>
struct MatIterator_ {
  T& operator*() const { return *at; }
  MatIterator_& operator++() { return *this; }
  bool operator!=(const MatIterator_&) const { return false; }
  T* at = nullptr;
};
struct Mat {
  Mat() = default;
  Mat(int, int, int) {}
  Mat(int, int, int, void*, std::size_t = 0) {}
  Mat clone() const { return {}; }
  void copyTo(Mat) const {}
  Mat operator()(int) const { return {}; }
  Mat& setTo(int) { return *this; }
  template <class T>
  T& at(int, int) {
    return *reinterpret_cast<T*>(data);
  }
  template <class T>
  const T& at(int, int) const {
    return *reinterpret_cast<const T*>(data);
  }
  unsigned char* ptr(int = 0) { return data; }
  const unsigned char* ptr(int = 0) const { return data; }
  bool empty() const { return !data; }
  int channels() const { return 1; }
  Mat& operator=(const Scalar&) { return *this; }
  template <class T>
  MatIterator_<T> begin() {
    return {};
  }
  template <class T>
  MatIterator_<T> end() {
    return {};
  }
  template <class T, class F>
  void forEach(const F&) {}
  void assignTo(Mat& m, int type = -1) const;
  std::size_t total() const { return 0; }
  unsigned char* data = nullptr;
  int rows = 0, cols = 0;
};
struct _InputArray {
  _InputArray(const Mat& mat) : obj(&mat) {}
  const void* obj;
};
struct _OutputArray : _InputArray {
  _OutputArray(Mat& mat) : _InputArray(mat) {}
  _OutputArray(const Mat& mat) : _InputArray(mat) {}
};
struct _InputOutputArray : _OutputArray {
  _InputOutputArray(Mat& mat) : _OutputArray(mat) {}
  _InputOutputArray(const Mat& mat) : _OutputArray(mat) {}
};
typedef const _InputArray& InputArray;
typedef const _OutputArray& OutputArray;
typedef const _InputOutputArray& InputOutputArray;
inline void flip(InputArray, OutputArray, int) {}
inline void circle(InputOutputArray, int) {}
inline int waitKey(int = 0) {
  return 0;
}
inline int createTrackbar(const std::string&, const std::string&, int*, int, void (*)(int, void*) = nullptr) {
  return 0;
}
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
inline CvImageConstPtr toCvShare(const sensor_msgs::ImageConstPtr&, const std::string& = "") {
  return {};
}
inline CvImageConstPtr toCvShare(const sensor_msgs::Image&, const boost::shared_ptr<void const>&,
                                 const std::string& = "") {
  return {};
}
inline CvImagePtr toCvCopy(const sensor_msgs::Image&, const std::string& = "") {
  return {};
}
inline CvImagePtr toCvCopy(const sensor_msgs::ImageConstPtr&, const std::string& = "") {
  return {};
}
}  // namespace cv_bridge

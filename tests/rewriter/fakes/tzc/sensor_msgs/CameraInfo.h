// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/CameraInfo.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct CameraInfo {
  typedef ::sensor_msgs::CameraInfo Stock;
  typedef boost::shared_ptr<CameraInfo> Ptr;
  typedef boost::shared_ptr<CameraInfo const> ConstPtr;
  CameraInfo() = default;
  explicit CameraInfo(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, CameraInfo&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::std_msgs::Header header;
  uint32_t height = 0, width = 0;
  std::string distortion_model;
  ::tzc::Array<double> D;
  boost::array<double, 9> K;
};
typedef boost::shared_ptr<CameraInfo> CameraInfoPtr;
typedef boost::shared_ptr<CameraInfo const> CameraInfoConstPtr;
inline std::ostream& operator<<(std::ostream& s, const CameraInfo&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc

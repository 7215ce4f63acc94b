// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/ScanRequest.h>
#include <tzc/array.h>
namespace tzc {
namespace sensor_msgs {
struct ScanRequest {
  typedef ::sensor_msgs::ScanRequest Stock;
  typedef boost::shared_ptr<ScanRequest> Ptr;
  typedef boost::shared_ptr<ScanRequest const> ConstPtr;
  ScanRequest() = default;
  explicit ScanRequest(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, ScanRequest&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::tzc::Array<uint8_t> data;
};
typedef boost::shared_ptr<ScanRequest> ScanRequestPtr;
typedef boost::shared_ptr<ScanRequest const> ScanRequestConstPtr;
inline std::ostream& operator<<(std::ostream& s, const ScanRequest&) {
  return s;
}
}  // namespace sensor_msgs
}  // namespace tzc

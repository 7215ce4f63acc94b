// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Float32MultiArray.h>
#include <tzc/array.h>
namespace tzc {
namespace std_msgs {
struct Float32MultiArray {
  typedef ::std_msgs::Float32MultiArray Stock;
  typedef boost::shared_ptr<Float32MultiArray> Ptr;
  typedef boost::shared_ptr<Float32MultiArray const> ConstPtr;
  Float32MultiArray() = default;
  explicit Float32MultiArray(const Stock&) {}
  template <class S>
  typename std::enable_if<std::is_same<S, Stock>::value, Float32MultiArray&>::type operator=(const S&) {
    return *this;
  }
  explicit operator Stock() const { return Stock(); }
  ::tzc::Array<float> data;
};
typedef boost::shared_ptr<Float32MultiArray> Float32MultiArrayPtr;
typedef boost::shared_ptr<Float32MultiArray const> Float32MultiArrayConstPtr;
inline std::ostream& operator<<(std::ostream& s, const Float32MultiArray&) {
  return s;
}
}  // namespace std_msgs
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <sensor_msgs/PointCloud2.h>
namespace {
inline int addPointField(sensor_msgs::PointCloud2&, const std::string&, int, int, int) {
  return 0;
}
}  // namespace
namespace sensor_msgs {
class PointCloud2Modifier {
 public:
  explicit PointCloud2Modifier(PointCloud2&) {}
  void resize(std::size_t) {}
  void setPointCloud2FieldsByString(int, ...) {}
};
template <class T>
class PointCloud2Iterator {
 public:
  PointCloud2Iterator(PointCloud2&, const std::string&) {}
  T& operator*() const { return *p_; }
  PointCloud2Iterator& operator++() { return *this; }
  bool operator!=(const PointCloud2Iterator&) const { return false; }
  PointCloud2Iterator end() const { return *this; }
  T* p_ = nullptr;
};
template <class T>
class PointCloud2ConstIterator {
 public:
  PointCloud2ConstIterator(const PointCloud2&, const std::string&) {}
  const T& operator*() const { return *p_; }
  PointCloud2ConstIterator& operator++() { return *this; }
  T* p_ = nullptr;
};
}  // namespace sensor_msgs

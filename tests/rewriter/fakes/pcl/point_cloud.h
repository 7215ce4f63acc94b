// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/core.h>
#include <vector>
namespace pcl {
struct PointXYZ {
  float x, y, z;
};
template <class T>
struct PointCloud {
  typedef boost::shared_ptr<PointCloud<T>> Ptr;
  typedef boost::shared_ptr<PointCloud<T> const> ConstPtr;
  std::vector<T> points;
  void push_back(const T& t) { points.push_back(t); }
  std::size_t size() const { return points.size(); }
  const T& at(std::size_t i) const { return points.at(i); }
};
struct PCLPointCloud2 {};
struct PCLImage {};
}  // namespace pcl

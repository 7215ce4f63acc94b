// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pcl_conversions/pcl_conversions.h>
#include <tzc/sensor_msgs/PointCloud2.h>
namespace tzc {
namespace pcl {
template <class T>
void toROSMsg(const ::pcl::PointCloud<T>&, sensor_msgs::PointCloud2&) {}
template <class T>
void fromROSMsg(const sensor_msgs::PointCloud2&, ::pcl::PointCloud<T>&) {}
}  // namespace pcl
namespace pcl_conversions {
inline void fromPCL(const ::pcl::PCLPointCloud2&, sensor_msgs::PointCloud2&) {}
inline void moveFromPCL(::pcl::PCLPointCloud2&, sensor_msgs::PointCloud2&) {}
}  // namespace pcl_conversions
}  // namespace tzc

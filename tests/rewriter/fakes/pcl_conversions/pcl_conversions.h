// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <pcl/point_cloud.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
namespace pcl {
template <class T>
void toROSMsg(const PointCloud<T>&, sensor_msgs::PointCloud2&) {}
template <class T>
void fromROSMsg(const sensor_msgs::PointCloud2&, PointCloud<T>&) {}
}  // namespace pcl
namespace pcl_conversions {
inline void fromPCL(const pcl::PCLPointCloud2&, sensor_msgs::PointCloud2&) {}
inline void moveFromPCL(pcl::PCLPointCloud2&, sensor_msgs::PointCloud2&) {}
inline void copyPCLPointCloud2MetaData(const pcl::PCLPointCloud2&, sensor_msgs::PointCloud2&) {}
inline void copyPCLImageMetaData(const pcl::PCLImage&, sensor_msgs::Image&) {}
inline void toPCL(const sensor_msgs::PointCloud2&, pcl::PCLPointCloud2&) {}
}  // namespace pcl_conversions

// SPDX-License-Identifier: BSD-3-Clause
// pcl_conversions for the tzc:: twins of pcl_msgs. Include <tzc/pcl.h>.
#pragma once

#include <tzc/pcl_msgs/ModelCoefficients.h>
#include <tzc/pcl_msgs/PointIndices.h>
#include <tzc/pcl_msgs/PolygonMesh.h>
#include <tzc/pcl_msgs/Vertices.h>

#include <pcl/ModelCoefficients.h>
#include <pcl/PointIndices.h>
#include <pcl/PolygonMesh.h>
#include <pcl/Vertices.h>
#include <pcl_conversions/pcl_conversions.h>

#include <utility>
#include <vector>

namespace tzc {
namespace pcl_conversions {

// As in <tzc/pcl.h>: fromPCL copies once, into shared memory when `to` is bound; moveFromPCL moves the data
// where the library does, unless `to` has shared memory for it.

inline void fromPCL(const ::pcl::PointIndices& from, pcl_msgs::PointIndices& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  to.indices = from.indices;
}
inline void moveFromPCL(::pcl::PointIndices& from, pcl_msgs::PointIndices& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  detail::exchange(from.indices, to.indices);
}

inline void fromPCL(const ::pcl::ModelCoefficients& from, pcl_msgs::ModelCoefficients& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  to.values = from.values;
}
inline void moveFromPCL(::pcl::ModelCoefficients& from, pcl_msgs::ModelCoefficients& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  detail::exchange(from.values, to.values);
}

/// PCL's indices have another type than the message's, so moving them is a copy, as in the library.
inline void fromPCL(const ::pcl::Vertices& from, pcl_msgs::Vertices& to) {
  to.vertices.assign(from.vertices.begin(), from.vertices.end());
}
inline void moveFromPCL(::pcl::Vertices& from, pcl_msgs::Vertices& to) {
  fromPCL(from, to);
}
inline void fromPCL(const std::vector< ::pcl::Vertices>& from, std::vector<pcl_msgs::Vertices>& to) {
  to.resize(from.size());
  for (std::size_t i = 0; i < from.size(); ++i) fromPCL(from[i], to[i]);
}

inline void fromPCL(const ::pcl::PolygonMesh& from, pcl_msgs::PolygonMesh& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  fromPCL(from.cloud, to.cloud);
  fromPCL(from.polygons, to.polygons);
}
/// Leaves the polygons out, as the library does.
inline void moveFromPCL(::pcl::PolygonMesh& from, pcl_msgs::PolygonMesh& to) {
  ::pcl_conversions::fromPCL(from.header, to.header);
  moveFromPCL(from.cloud, to.cloud);
}

}  // namespace pcl_conversions
}  // namespace tzc

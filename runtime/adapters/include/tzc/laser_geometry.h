// SPDX-License-Identifier: BSD-3-Clause
// laser_geometry for tzc:: messages: a scan is projected into shared memory. Header-only; link laser_geometry as before.
#pragma once

#include <tzc/array.h>
#include <tzc/detail/vector_words.h>
#include <tzc/sensor_msgs/PointCloud2.h>

#include <laser_geometry/laser_geometry.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace tzc {
namespace laser_geometry {

namespace detail {

/// A stock cloud in place of a tzc:: cloud, for a library that fills it: its data is the tzc:: cloud's, of which it may use as many bytes
/// as were asked for. The tzc:: cloud gets what it holds in the end, also when the library throws.
class LentCloud {
 public:
  LentCloud(sensor_msgs::PointCloud2& cloud, std::size_t most_bytes) : cloud_(cloud) {
    static_assert(tzc::detail::HasVectorWords<std::vector<std::uint8_t> >::value,
                  "projectLaser needs a std::vector that consists of three pointers");
    cloud.data.resize(most_bytes, uninitialized);
    std::uint8_t* const begin = cloud.data.data();
    exchange_description();
    tzc::detail::VectorWords{begin, begin, begin + most_bytes}.write_to(&stock_.data);
  }
  LentCloud(const LentCloud&) = delete;
  LentCloud& operator=(const LentCloud&) = delete;
  ~LentCloud() {
    const std::size_t size = stock_.data.size();
    tzc::detail::VectorWords::clear(&stock_.data);
    cloud_.data.resize(size);
    exchange_description();
  }

  ::sensor_msgs::PointCloud2& stock() { return stock_; }

 private:
  void exchange_description() {
    std::swap(stock_.header, cloud_.header);
    stock_.fields.swap(cloud_.fields);
    std::swap(stock_.height, cloud_.height);
    std::swap(stock_.width, cloud_.width);
    std::swap(stock_.is_bigendian, cloud_.is_bigendian);
    std::swap(stock_.point_step, cloud_.point_step);
    std::swap(stock_.row_step, cloud_.row_step);
    std::swap(stock_.is_dense, cloud_.is_dense);
  }

  sensor_msgs::PointCloud2& cloud_;
  ::sensor_msgs::PointCloud2 stock_;
};

/// The most that the library asks for, for each beam of such a scan: measured with a scan of one beam, by a projector of its own, because
/// projectors remember the angles of their last scan.
inline std::size_t bytes_of_beam(const ::sensor_msgs::LaserScan& scan, int channel_options) {
  ::sensor_msgs::LaserScan beam;
  beam.range_max = 2;
  beam.ranges.assign(1, 1);
  if (!scan.intensities.empty()) beam.intensities.assign(1, 0);
  ::sensor_msgs::PointCloud2 point;
  ::laser_geometry::LaserProjection().projectLaser(beam, point, -1.0, channel_options);
  return point.data.capacity();
}

}  // namespace detail

/// LaserProjection::projectLaser for a tzc:: cloud: the library writes the points where they are published from, in shared memory when the
/// cloud is allocated or bound. `projector` is not thread-safe, as before.
inline void projectLaser(::laser_geometry::LaserProjection& projector, const ::sensor_msgs::LaserScan& scan,
                         sensor_msgs::PointCloud2& cloud, double range_cutoff = -1.0,
                         int channel_options = ::laser_geometry::channel_option::Default) {
  detail::LentCloud lent(cloud, scan.ranges.size() * detail::bytes_of_beam(scan, channel_options));
  projector.projectLaser(scan, lent.stock(), range_cutoff, channel_options);
}

}  // namespace laser_geometry
}  // namespace tzc

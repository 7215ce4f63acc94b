// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tzc/sensor_msgs/PointCloud2.h>

#include <sensor_msgs/point_cloud2_iterator.h>

#include <cstddef>
#include <cstdint>

namespace tzc {
namespace sensor_msgs {

/// sensor_msgs::PointCloud2Modifier for tzc:: clouds; include <tzc/sensor_msgs.h>.
class PointCloud2Modifier {
 public:
  explicit PointCloud2Modifier(PointCloud2& cloud) : cloud_(cloud) {}

  /// Number of points.
  std::size_t size() const { return cloud_.data.size() / cloud_.point_step; }
  void reserve(std::size_t points) { cloud_.data.reserve(points * cloud_.point_step); }

  /// A cloud of one row grows in width, one of one column in height; any other becomes one row.
  void resize(std::size_t points) {
    cloud_.data.resize(points * cloud_.point_step);
    const bool is_column = cloud_.width == 1 && cloud_.height != 1;
    if (is_column) {
      cloud_.height = static_cast<std::uint32_t>(points);
      return;
    }
    cloud_.height = 1;
    cloud_.width = static_cast<std::uint32_t>(points);
    cloud_.row_step = static_cast<std::uint32_t>(points * cloud_.point_step);
  }

  void clear() {
    cloud_.data.clear();
    const bool is_row = cloud_.height == 1, is_column = !is_row && cloud_.width == 1;
    if (!is_column) cloud_.row_step = cloud_.width = 0;
    if (!is_row) cloud_.height = 0;
  }

  /// Triplets name, count, sensor_msgs::PointField datatype, as for sensor_msgs' own.
  template <class... Fields>
  void setPointCloud2Fields(int fields, Fields... descriptions) {
    change_fields(
        [&](::sensor_msgs::PointCloud2Modifier& m) { m.setPointCloud2Fields(fields, descriptions...); });
  }
  /// Names: "xyz", "rgb", "rgba", as for sensor_msgs' own. Throws std::runtime_error for another name.
  template <class... Fields>
  void setPointCloud2FieldsByString(int fields, Fields... names) {
    change_fields(
        [&](::sensor_msgs::PointCloud2Modifier& m) { m.setPointCloud2FieldsByString(fields, names...); });
  }

 private:
  /// Lets the library change a stock cloud without rows, which therefore needs no data.
  template <class Change>
  void change_fields(Change change) {
    ::sensor_msgs::PointCloud2 stock;
    stock.width = cloud_.width;
    ::sensor_msgs::PointCloud2Modifier modifier(stock);
    change(modifier);
    cloud_.fields.swap(stock.fields);
    cloud_.point_step = stock.point_step;
    cloud_.row_step = stock.row_step;
    cloud_.data.resize(cloud_.height * cloud_.row_step);
  }

  PointCloud2& cloud_;
};

}  // namespace sensor_msgs
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
// Most catkin packages are built as C++14: what they include must be.
#include <gtest/gtest.h>
#include <tzc/array.h>
#include <tzc/memory.h>
#include <tzc/message.h>
#include <tzc/sensor_msgs/PointCloud.h>

static_assert(__cplusplus < 201500L, "this file is to be compiled as C++14");

namespace tzc {

template class Array<std::uint8_t>;
template class Array<double>;

namespace {

TEST(Cxx14, MessagesCompileAndWork) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(3);
  const auto memory = SegmentMemory::create();
  ASSERT_TRUE(bool(memory));
  ASSERT_TRUE(message::allocate(cloud, memory.value()));
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(cloud, *memory.value(), encoded));
  EXPECT_EQ(3u, message::stock_view(cloud, encoded)->points.size());
  EXPECT_TRUE(message::make_copy<::sensor_msgs::PointCloud>(nullptr, 0, {}) == nullptr);
}

}  // namespace
}  // namespace tzc

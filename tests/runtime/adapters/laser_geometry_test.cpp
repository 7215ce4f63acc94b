// SPDX-License-Identifier: BSD-3-Clause
// tzc::laser_geometry against the library: the same clouds, written where they are published from.
#include <tzc/laser_geometry.h>
#include <tzc/message.h>

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <stdexcept>

#include "copies.h"

namespace tzc {
namespace {

constexpr int every_channel =
    ::laser_geometry::channel_option::Intensity | ::laser_geometry::channel_option::Index |
    ::laser_geometry::channel_option::Distance | ::laser_geometry::channel_option::Timestamp |
    ::laser_geometry::channel_option::Viewpoint;

class ProjectLaser : public ::testing::Test {
 protected:
  std::size_t any(std::size_t most) { return std::uniform_int_distribution<std::size_t>(0, most)(random_); }

  /// Ranges that are kept and ranges that are dropped.
  float any_range() {
    static const float odd[] = {0, -1, std::numeric_limits<float>::infinity(),
                                std::numeric_limits<float>::quiet_NaN(), 1e6F};
    return any(3) == 0 ? odd[any(4)] : static_cast<float>(any(3000)) / 100;
  }
  ::sensor_msgs::LaserScan any_scan() {
    ::sensor_msgs::LaserScan scan;
    scan.header.seq = static_cast<std::uint32_t>(any(100));
    scan.header.frame_id = "laser";
    scan.angle_min = -1;
    scan.angle_increment = 0.01F;
    scan.time_increment = 0.001F;
    scan.range_min = 0.1F;
    scan.range_max = 25;
    scan.ranges.resize(any(4) == 0 ? any(2) : any(700));
    for (float& range : scan.ranges) range = any_range();
    if (any(1) == 0) scan.intensities.resize(scan.ranges.size());
    for (float& intensity : scan.intensities) intensity = static_cast<float>(any(255));
    return scan;
  }
  /// The same projection with the library and with TZC.
  void project_both(const ::sensor_msgs::LaserScan& scan, double cutoff, int channels) {
    librarys_.projectLaser(scan, stock_, cutoff, channels);
    laser_geometry::projectLaser(ours_, scan, cloud_, cutoff, channels);
    ASSERT_EQ(stock_, message::to_stock(cloud_)) << scan.ranges.size() << " beams, channels " << channels;
  }

  std::mt19937 random_{17};
  ::laser_geometry::LaserProjection librarys_, ours_;
  ::sensor_msgs::PointCloud2 stock_;
  sensor_msgs::PointCloud2 cloud_;
  test::FakePublisher publisher_;
};

TEST_F(ProjectLaser, any_scan_gives_the_librarys_cloud) {
  for (int i = 0; i < 2000; ++i) {
    if (any(9) == 0) {
      stock_ = ::sensor_msgs::PointCloud2();
      stock_.is_bigendian = any(1) != 0;
      cloud_ = stock_;
      if (any(1) == 0) ASSERT_TRUE(message::allocate(cloud_, publisher_.memory()));
    }
    project_both(any_scan(), any(1) == 0 ? -1.0 : static_cast<double>(any(20)),
                 static_cast<int>(any(every_channel)));
    if (HasFatalFailure()) return;
  }
}

TEST_F(ProjectLaser, the_usual_arguments_are_the_librarys) {
  const ::sensor_msgs::LaserScan scan = any_scan();
  librarys_.projectLaser(scan, stock_);
  laser_geometry::projectLaser(ours_, scan, cloud_);
  EXPECT_EQ(stock_, message::to_stock(cloud_));
}

TEST_F(ProjectLaser, a_published_cloud_keeps_its_points) {
  ASSERT_TRUE(message::allocate(cloud_, publisher_.memory()));
  project_both(any_scan(), -1, every_channel);
  message::Encoded published;
  ASSERT_TRUE(message::encode(cloud_, publisher_.test_memory, published));
  const auto view = message::stock_view(cloud_, published);
  const ::sensor_msgs::PointCloud2 before = *view;
  project_both(any_scan(), -1, every_channel);
  EXPECT_EQ(before, *view);
}

TEST_F(ProjectLaser, points_are_written_where_they_are_published_from) {
  ::sensor_msgs::LaserScan scan = any_scan();
  scan.ranges.assign(10000, 1);
  scan.intensities.clear();
  ASSERT_TRUE(message::allocate(cloud_, publisher_.memory()));
  project_both(scan, -1, every_channel);
  ASSERT_EQ(10000U, cloud_.width);
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(cloud_, publisher_.test_memory, encoded));
  EXPECT_EQ(0U, encoded.copied_bytes);
}

TEST_F(ProjectLaser, what_throws_leaves_a_cloud_that_can_be_used) {
  try {
    laser_geometry::detail::LentCloud lent(cloud_, 64);
    lent.stock().data.resize(8, 7);
    lent.stock().width = 2;
    throw std::runtime_error("the library");
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ("the library", error.what());
  }
  EXPECT_EQ(std::vector<std::uint8_t>(8, 7),
            std::vector<std::uint8_t>(cloud_.data.cbegin(), cloud_.data.cend()));
  EXPECT_EQ(2U, cloud_.width);
  cloud_.data.resize(100);
}

}  // namespace
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
// tzc::pcl and tzc::pcl_conversions against the libraries: the same messages, no more copies.
#include <pcl/console/print.h>
#include <pcl/point_types.h>
#include <pcl_ros/point_cloud.h>
#include <tzc/std_msgs/Float32MultiArray.h>  // makes a namespace tzc::std_msgs, which must not hide the stock one
//
#include <tzc/advertise.h>
#include <tzc/pcl.h>

#include "copies.h"

namespace tzc {
namespace {

using Point = ::pcl::PointXYZRGB;
using Cloud = ::pcl::PointCloud<Point>;

static_assert(message::HasPartialForm<Cloud>::value, "travels as PointCloud2's control part and data");
static_assert(message::HasPartialForm<::pcl::PCLPointCloud2>::value,
              "travels as PointCloud2's control part and data");

Cloud cloud_of(std::uint32_t width, std::uint32_t height) {
  Cloud cloud(width, height);
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    cloud.points[i].x = static_cast<float>(i);
    cloud.points[i].r = static_cast<std::uint8_t>(i);
  }
  cloud.header.frame_id = "lidar";
  cloud.header.stamp = 1234567;
  cloud.is_dense = false;
  return cloud;
}

::sensor_msgs::PointCloud2 librarys_message(const Cloud& cloud) {
  ::sensor_msgs::PointCloud2 message;
  ::pcl::toROSMsg(cloud, message);
  return message;
}

std::vector<std::uint8_t> wire(const Cloud& cloud) {
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(cloud));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, cloud);
  return bytes;
}

/// Without the points, between whose fields there is padding.
::sensor_msgs::PointCloud2 described(const Cloud& cloud) {
  ::sensor_msgs::PointCloud2 message = librarys_message(cloud);
  message.data.clear();
  return message;
}

class Pcl : public ::testing::Test {
 protected:
  message::Encoded encoded(const Cloud& cloud) {
    message::Encoded result;
    EXPECT_TRUE(message::encode(cloud, publisher_.test_memory, result));
    return result;
  }
  template <class As>
  auto received_as(const ::sensor_msgs::PointCloud2& message) {
    message::Encoded result;
    EXPECT_TRUE(message::encode(message, publisher_.test_memory, result));
    return message::make_copy<As>(result.control.data(), result.control.size(), blocks(result));
  }
  static std::vector<ConstBlock> blocks(const message::Encoded& encoded) {
    std::vector<ConstBlock> all;
    for (const BufferPtr& buffer : encoded.buffers) all.push_back(ConstBlock{buffer->data(), buffer->size()});
    return all;
  }

  test::FakePublisher publisher_;
};

/// roscpp does not count header.seq of clouds; a subscriber must not be able to tell that the node was ported.
TEST(Advertise, header_seq_is_counted_as_by_roscpp) {
  ros::AdvertiseOptions stock;
  stock.init<Cloud>("points", 1);
  EXPECT_FALSE(stock.has_header);
  EXPECT_FALSE(tzc::detail::advertise_options<Cloud>("points", 1).has_header);
  EXPECT_FALSE(tzc::detail::codec_for<Cloud>(stock).has_header);
  EXPECT_TRUE(tzc::detail::advertise_options<sensor_msgs::PointCloud2>("points", 1).has_header);
  EXPECT_TRUE(tzc::detail::advertise_options<::sensor_msgs::PointCloud2>("points", 1).has_header);
}

TEST_F(Pcl, reads_a_message_as_the_library_does) {
  for (const auto& cloud : {cloud_of(7, 3), cloud_of(5, 1), Cloud()}) {
    const ::sensor_msgs::PointCloud2 stock = librarys_message(cloud);
    const sensor_msgs::PointCloud2 message(stock);
    Cloud expected, read;
    ::pcl::fromROSMsg(stock, expected);
    pcl::fromROSMsg(message, read);
    EXPECT_EQ(described(expected), described(read));
    ASSERT_EQ(expected.size(), read.size());
    for (std::size_t i = 0; i < read.size(); ++i) {
      EXPECT_EQ(expected[i].x, read[i].x);
      EXPECT_EQ(expected[i].rgba, read[i].rgba);
    }
    ::pcl::PointCloud<::pcl::PointXYZ> fewer_expected, fewer;  // other fields: point by point
    ::pcl::fromROSMsg(stock, fewer_expected);
    pcl::fromROSMsg(message, fewer);
    ASSERT_EQ(fewer_expected.size(), fewer.size());
    for (std::size_t i = 0; i < fewer.size(); ++i) EXPECT_EQ(fewer_expected[i].x, fewer[i].x);
  }
}

TEST_F(Pcl, to_ros_msg_builds_the_librarys_message) {
  for (const Cloud& cloud : {cloud_of(10, 20), cloud_of(300, 1), Cloud()}) {
    sensor_msgs::PointCloud2 message;
    pcl::toROSMsg(cloud, message);
    EXPECT_EQ(librarys_message(cloud), message::to_stock(message));
  }
}

TEST_F(Pcl, to_ros_msg_copies_once_like_the_library) {
  const Cloud cloud = cloud_of(1000, 100);
  const std::size_t size = cloud.points.size() * sizeof(Point);
  const auto& memory = publisher_.test_memory;
  const auto librarys = test::places_for(size, memory, [&] { librarys_message(cloud); });
  const auto ours = test::places_for(size, memory, [&] {
    sensor_msgs::PointCloud2 message;
    ASSERT_TRUE(message::allocate(message, publisher_.memory()));
    pcl::toROSMsg(cloud, message);
    message::Encoded encoded;
    ASSERT_TRUE(message::encode(message, memory, encoded));
    EXPECT_EQ(0u, encoded.copied_bytes) << "publishing copies nothing more";
  });
  EXPECT_EQ(1u, librarys);
  EXPECT_EQ(1u, ours);
}

TEST_F(Pcl, from_pcl_converts_like_the_library) {
  const Cloud cloud = cloud_of(10, 20);
  ::pcl::PCLPointCloud2 blob;
  ::pcl::toPCLPointCloud2(cloud, blob);
  sensor_msgs::PointCloud2 copied, moved;
  pcl_conversions::fromPCL(blob, copied);
  const auto* const data = blob.data.data();
  pcl_conversions::moveFromPCL(blob, moved);
  EXPECT_EQ(librarys_message(cloud), message::to_stock(copied));
  EXPECT_EQ(copied, moved);
  EXPECT_EQ(data, moved.data.data()) << "moving copies nothing";
}

TEST_F(Pcl, move_from_pcl_exchanges_the_data_as_the_library_does) {
  for (const std::vector<std::uint8_t>& before :
       {std::vector<std::uint8_t>(), std::vector<std::uint8_t>(300, 7)}) {
    ::pcl::PCLPointCloud2 librarys, ours;
    librarys.data.assign(200, 1), ours.data.assign(200, 1);
    ::sensor_msgs::PointCloud2 stock;
    stock.data = before;
    sensor_msgs::PointCloud2 message;
    ASSERT_TRUE(message::allocate(message, publisher_.memory()));
    message.data = before;
    ::pcl_conversions::moveFromPCL(librarys, stock);
    pcl_conversions::moveFromPCL(ours, message);
    EXPECT_EQ(librarys.data, ours.data);
    EXPECT_EQ(stock.data, std::vector<std::uint8_t>(message.data));
  }
}

TEST_F(Pcl, from_pcl_converts_images) {
  ::pcl::PCLImage image;
  image.header.frame_id = "camera";
  image.height = 2, image.width = 3, image.step = 9, image.encoding = "bgr8";
  image.data.assign(18, 5);
  ::sensor_msgs::Image stock;
  ::pcl_conversions::fromPCL(image, stock);
  sensor_msgs::Image copied, moved;
  pcl_conversions::fromPCL(image, copied);
  pcl_conversions::moveFromPCL(image, moved);
  EXPECT_EQ(stock, message::to_stock(copied));
  EXPECT_EQ(stock, message::to_stock(moved));
}

TEST_F(Pcl, a_published_cloud_is_seen_as_point_cloud2) {
  for (const Cloud& cloud : {cloud_of(10, 20), cloud_of(300, 1), Cloud()}) {
    auto result = encoded(cloud);
    EXPECT_EQ(cloud.points.size() * sizeof(Point), result.copied_bytes);
    const auto view = message::stock_view(cloud, result);
    ASSERT_TRUE(view);
    EXPECT_EQ(librarys_message(cloud), *view);
  }
}

TEST_F(Pcl, a_published_cloud_is_what_pcl_ros_serializes) {
  const Cloud cloud = cloud_of(10, 20);
  auto result = encoded(cloud);
  const auto view = message::stock_view(cloud, result);
  std::vector<std::uint8_t> bytes(ros::serialization::serializationLength(*view));
  ros::serialization::OStream stream(bytes.data(), static_cast<std::uint32_t>(bytes.size()));
  ros::serialization::serialize(stream, *view);
  EXPECT_EQ(wire(cloud), bytes);
}

TEST_F(Pcl, pcl_point_cloud2_is_published_without_its_own_type) {
  const Cloud cloud = cloud_of(10, 20);
  ::pcl::PCLPointCloud2 blob;
  ::pcl::toPCLPointCloud2(cloud, blob);
  message::Encoded result;
  ASSERT_TRUE(message::encode(blob, publisher_.test_memory, result));
  EXPECT_EQ(librarys_message(cloud), *message::stock_view(blob, result));
}

TEST_F(Pcl, a_callback_may_take_the_point_type) {
  const Cloud cloud = cloud_of(10, 20);
  const auto result = encoded(cloud);
  const auto received =
      message::make_copy<Cloud>(result.control.data(), result.control.size(), blocks(result));
  ASSERT_TRUE(received);
  EXPECT_EQ(cloud.header.stamp, received->header.stamp);
  ASSERT_EQ(cloud.points.size(), received->points.size());
  for (std::size_t i = 0; i < cloud.points.size(); ++i) {
    EXPECT_EQ(cloud.points[i].x, received->points[i].x);
    EXPECT_EQ(cloud.points[i].r, received->points[i].r);
  }

  using Other = ::pcl::PointCloud<::pcl::PointXYZ>;
  const auto other = message::make_copy<Other>(result.control.data(), result.control.size(), blocks(result));
  ASSERT_TRUE(other);
  EXPECT_EQ(7, other->points[7].x);
}

TEST_F(Pcl, a_callback_may_take_pcl_point_cloud2) {
  const Cloud cloud = cloud_of(10, 20);
  const auto result = encoded(cloud);
  const auto received =
      message::make_copy<::pcl::PCLPointCloud2>(result.control.data(), result.control.size(), blocks(result));
  ASSERT_TRUE(received);
  ::sensor_msgs::PointCloud2 message;
  ::pcl_conversions::fromPCL(*received, message);
  EXPECT_EQ(librarys_message(cloud), message);
}

/// Without padding PCL copies all the data of a message, however many points there are.
TEST_F(Pcl, data_behind_the_points_is_not_read) {
  using Flat = ::pcl::PointCloud<::pcl::PointXY>;
  Flat cloud(1000, 1);
  cloud.points[0].y = 7;
  ::sensor_msgs::PointCloud2 message;
  ::pcl::toROSMsg(cloud, message);
  message.width = 1;
  message.row_step = message.point_step;
  const auto received = received_as<Flat>(message);
  ASSERT_TRUE(received);
  ASSERT_EQ(received->points.size(), 1u);
  EXPECT_EQ(received->points[0].y, 7);
}

TEST_F(Pcl, a_single_row_needs_no_step) {
  const Cloud cloud = cloud_of(10, 1);
  ::sensor_msgs::PointCloud2 message = librarys_message(cloud);
  message.row_step = 0;
  const auto received = received_as<Cloud>(message);
  ASSERT_TRUE(received);
  ASSERT_EQ(received->points.size(), 10u);
  EXPECT_EQ(received->points[9].x, 9);
}

TEST_F(Pcl, hostile_clouds_are_refused_or_harmless) {
  ::pcl::console::setVerbosityLevel(::pcl::console::L_ALWAYS);  // PCL complains about unknown fields
  const auto result = encoded(cloud_of(4, 5));
  const auto& control = result.control;
  // Blocks of exactly the cloud's size, so that AddressSanitizer sees one byte too many.
  const std::vector<std::uint8_t> data(result.buffers[0]->data(),
                                       result.buffers[0]->data() + 20 * sizeof(Point));
  const std::vector<ConstBlock> exact{ConstBlock{data.data(), data.size()}};
  ASSERT_TRUE(message::make_copy<Cloud>(control.data(), control.size(), exact));
  for (std::size_t at = 0; at < control.size(); ++at) {
    EXPECT_FALSE(message::make_copy<Cloud>(control.data(), at, exact)) << "cut at " << at;
    for (const int mask : {0x01, 0x10, 0x80, 0xff}) {
      auto flipped = control;
      flipped[at] ^= static_cast<std::uint8_t>(mask);
      message::make_copy<Cloud>(flipped.data(), flipped.size(), exact);
    }
  }
}

}  // namespace
}  // namespace tzc

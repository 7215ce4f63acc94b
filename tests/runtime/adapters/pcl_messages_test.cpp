// SPDX-License-Identifier: BSD-3-Clause
// tzc::pcl and tzc::pcl_conversions against the libraries, one message type after the other: what both make
// is equal, and ours takes no more copies, publishing included.
#include <pcl/point_types.h>
#include <tzc/message.h>
#include <tzc/pcl.h>

#include <algorithm>

#include "copies.h"

namespace tzc {
namespace {

using Point = ::pcl::PointXYZRGB;
using Cloud = ::pcl::PointCloud<Point>;

Cloud colored_cloud(std::uint32_t width, std::uint32_t height) {
  Cloud cloud(width, height);
  std::uint8_t shade = 0;
  for (Point& point : cloud.points)
    point.r = ++shade, point.g = 77, point.b = static_cast<std::uint8_t>(3 * shade);
  cloud.header.frame_id = "lidar";
  cloud.header.stamp = 1234567;
  return cloud;
}

::sensor_msgs::PointCloud2 librarys_message(const Cloud& cloud) {
  ::sensor_msgs::PointCloud2 message;
  ::pcl::toROSMsg(cloud, message);
  message.header.stamp.nsec += 7;  // which PCL's clock cannot tell
  return message;
}

/// `convert(message)` makes the same of a stock message and of a twin with shared memory. `librarys_places`
/// of `size` bytes are what the library takes; ours takes no more, and then the message needs no other place
/// to be published. What is moved, into no place at all, takes one when it is published, be it the
/// serializer's or a block.
template <class Twin, class Convert>
void expect_same_and_no_more_copies(std::size_t size, std::size_t librarys_places, Convert convert) {
  test::FakePublisher publisher;
  const auto& memory = publisher.test_memory;
  typename Twin::Stock stock;
  Twin twin;
  ASSERT_TRUE(message::allocate(twin, publisher.memory()));
  message::Encoded encoded;
  const auto librarys = test::places_for(size, memory, [&] { convert(stock); });
  const auto ours = test::places_for(size, memory, [&] {
    convert(twin);
    ASSERT_TRUE(message::encode(twin, memory, encoded));
  });
  EXPECT_TRUE(stock == message::to_stock(twin));
  EXPECT_EQ(librarys_places, librarys);
  EXPECT_LE(ours, std::max<std::size_t>(librarys, 1));
  if (librarys_places != 0) {
    EXPECT_EQ(0u, encoded.copied_bytes) << "publishing copies nothing more";
  }
}

TEST(Color, of_a_cloud_of_points) {
  const Cloud cloud = colored_cloud(400, 300);
  expect_same_and_no_more_copies<sensor_msgs::Image>(400 * 300 * 3, 1, [&](auto& image) {
    using ::pcl::toROSMsg;
    using pcl::toROSMsg;
    toROSMsg(cloud, image);
  });
}

TEST(Color, of_a_message) {
  const ::sensor_msgs::PointCloud2 cloud = librarys_message(colored_cloud(400, 300));
  expect_same_and_no_more_copies<sensor_msgs::Image>(400 * 300 * 3, 2, [&](auto& image) {
    using ::pcl::toROSMsg;
    using pcl::toROSMsg;
    toROSMsg(cloud, image);
  });
  ::sensor_msgs::PointCloud2 clouds[2] = {cloud, cloud};
  auto* next = clouds;
  expect_same_and_no_more_copies<sensor_msgs::Image>(400 * 300 * 3, 1, [&](auto& image) {
    using ::pcl::moveToROSMsg;
    using pcl::moveToROSMsg;
    moveToROSMsg(*next++, image);
  });
  EXPECT_TRUE(clouds[0] == clouds[1]) << "without data";
}

TEST(Color, is_refused_as_by_the_library) {
  sensor_msgs::Image image;
  Cloud shapeless = colored_cloud(2, 2);
  shapeless.width = shapeless.height = 0;
  EXPECT_THROW(pcl::toROSMsg(shapeless, image), std::runtime_error);
  shapeless.width = 3, shapeless.height = 1;
  EXPECT_THROW(pcl::toROSMsg(shapeless, image), std::runtime_error);
  const ::pcl::PointCloud< ::pcl::PointXYZ> colorless(2, 2);
  ::sensor_msgs::PointCloud2 message;
  ::pcl::toROSMsg(colorless, message);
  EXPECT_THROW(pcl::toROSMsg(message, image), std::runtime_error);
  ::sensor_msgs::PointCloud2 cut = librarys_message(colored_cloud(4, 4));
  cut.data.pop_back();
  EXPECT_NO_THROW(pcl::toROSMsg(cut, image)) << "the color is there";
  cut.data.resize(cut.data.size() - sizeof(Point));
  EXPECT_THROW(pcl::toROSMsg(cut, image), std::runtime_error);
}

template <class Twin, class FromPcl>
void expect_converted(std::size_t size, const FromPcl& source) {
  expect_same_and_no_more_copies<Twin>(size, 1, [&](auto& message) {
    using ::pcl_conversions::fromPCL;
    using tzc::pcl_conversions::fromPCL;
    fromPCL(source, message);
  });
}
template <class Twin, class FromPcl>
void expect_moved(std::size_t size, std::size_t librarys_places, const FromPcl& source) {
  FromPcl sources[2] = {source, source};
  FromPcl* next = sources;
  expect_same_and_no_more_copies<Twin>(size, librarys_places, [&](auto& message) {
    using ::pcl_conversions::moveFromPCL;
    using pcl_conversions::moveFromPCL;
    moveFromPCL(*next++, message);
  });
}

template <class Message>
Message with_header() {
  Message message;
  message.header.frame_id = "lidar";
  message.header.stamp = 5000;
  return message;
}

TEST(PclMsgs, point_indices) {
  auto indices = with_header< ::pcl::PointIndices>();
  for (int i = 0; i < 100000; ++i) indices.indices.push_back(i);
  expect_converted<pcl_msgs::PointIndices>(400000, indices);
  expect_moved<pcl_msgs::PointIndices>(400000, 0, indices);
}

TEST(PclMsgs, model_coefficients) {
  auto model = with_header< ::pcl::ModelCoefficients>();
  model.values.assign(100000, 2.5f);
  expect_converted<pcl_msgs::ModelCoefficients>(400000, model);
  expect_moved<pcl_msgs::ModelCoefficients>(400000, 0, model);
}

TEST(PclMsgs, vertices) {
  ::pcl::Vertices vertices;
  vertices.vertices.assign(100000, 7);
  expect_converted<pcl_msgs::Vertices>(400000, vertices);
  expect_moved<pcl_msgs::Vertices>(400000, 1, vertices);
}

TEST(PclMsgs, polygon_mesh) {
  auto mesh = with_header< ::pcl::PolygonMesh>();
  ::pcl::toPCLPointCloud2(colored_cloud(100, 100), mesh.cloud);
  expect_converted<pcl_msgs::PolygonMesh>(mesh.cloud.data.size(), mesh);
  expect_moved<pcl_msgs::PolygonMesh>(mesh.cloud.data.size(), 0, mesh);

  mesh.polygons.resize(3);
  for (auto& polygon : mesh.polygons) polygon.vertices = {1, 2, 3};
  ::pcl_msgs::PolygonMesh stock;
  pcl_msgs::PolygonMesh twin;
  ::pcl_conversions::fromPCL(mesh, stock);
  pcl_conversions::fromPCL(mesh, twin);
  EXPECT_EQ(3u, twin.polygons.size());
  EXPECT_TRUE(stock == message::to_stock(twin));
}

}  // namespace
}  // namespace tzc

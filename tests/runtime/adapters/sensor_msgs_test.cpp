// SPDX-License-Identifier: BSD-3-Clause
// tzc::sensor_msgs' helpers against sensor_msgs' own: whatever is done to both, they stay equal.
#include <sensor_msgs/fill_image.h>
#include <tzc/message.h>
#include <tzc/sensor_msgs.h>

#include <random>

#include "copies.h"

namespace tzc {
namespace {

using Field = ::sensor_msgs::PointField;

struct Clouds {
  ::sensor_msgs::PointCloud2 stock;
  sensor_msgs::PointCloud2 ours;

  void expect_equal() const { EXPECT_EQ(stock, message::to_stock(ours)); }
};

/// Calls `change` with each cloud's modifier.
template <class Change>
void modify(Clouds& clouds, Change change) {
  ::sensor_msgs::PointCloud2Modifier stock(clouds.stock);
  sensor_msgs::PointCloud2Modifier ours(clouds.ours);
  change(stock);
  change(ours);
  if (clouds.stock.point_step != 0) {
    EXPECT_EQ(stock.size(), ours.size());
  }
  clouds.expect_equal();
}

TEST(AddPointField, adds_like_the_library) {
  Clouds clouds;
  modify(clouds, [](auto& modifier) { modifier.setPointCloud2FieldsByString(1, "xyz"); });
  const int offset = ::addPointField(clouds.stock, "ring", 2, Field::UINT16, 16);
  EXPECT_EQ(offset, sensor_msgs::addPointField(clouds.ours, "ring", 2, Field::UINT16, 16));
  clouds.expect_equal();
  constexpr int unknown = 77;
  EXPECT_THROW(::addPointField(clouds.stock, "odd", 1, unknown, offset), std::runtime_error);
  EXPECT_THROW(sensor_msgs::addPointField(clouds.ours, "odd", 1, unknown, offset), std::runtime_error);
  clouds.expect_equal();
}

TEST(FillImage, fills_like_the_library) {
  const std::vector<std::uint8_t> pixels(20 * 10, 7);
  ::sensor_msgs::Image stock;
  sensor_msgs::Image ours;
  EXPECT_TRUE(::sensor_msgs::fillImage(stock, "mono8", 10, 16, 20, pixels.data()));
  EXPECT_TRUE(sensor_msgs::fillImage(ours, "mono8", 10, 16, 20, pixels.data()));
  EXPECT_EQ(stock, message::to_stock(ours));
  sensor_msgs::clearImage(ours);
  EXPECT_TRUE(ours.data.empty());
}

TEST(FillImage, takes_any_size_that_the_library_takes) {
  const std::vector<std::uint8_t> pixels(64, 7);
  struct Shape {
    std::uint32_t rows, columns, step;
  };
  for (const Shape& shape :
       {Shape{0, 8, 8}, Shape{8, 0, 0}, Shape{0, 0, 0}, Shape{4, 100, 3},
        Shape{1u << 16, 1, 1u << 16}}) {  // the last one's size is 2^32, which wraps to 0
    SCOPED_TRACE(std::to_string(shape.rows) + " rows of " + std::to_string(shape.step));
    ::sensor_msgs::Image stock;
    sensor_msgs::Image ours;
    stock.data.assign(5, 1), ours.data.assign(5, 1);
    stock.is_bigendian = ours.is_bigendian = 1;
    EXPECT_TRUE(
        ::sensor_msgs::fillImage(stock, "mono8", shape.rows, shape.columns, shape.step, pixels.data()));
    EXPECT_TRUE(sensor_msgs::fillImage(ours, "mono8", shape.rows, shape.columns, shape.step, pixels.data()));
    EXPECT_EQ(stock, message::to_stock(ours));
  }
  sensor_msgs::Image empty;
  EXPECT_TRUE(sensor_msgs::fillImage(empty, "mono8", 0, 0, 0, nullptr));
}

TEST(FillImage, copies_once_like_the_library) {
  const std::vector<std::uint8_t> pixels(1 << 20, 7);
  test::FakePublisher publisher;
  sensor_msgs::Image ours;
  ASSERT_TRUE(message::allocate(ours, publisher.memory()));
  EXPECT_EQ(1u, test::places_for(pixels.size(), publisher.test_memory, [&] {
              sensor_msgs::fillImage(ours, "mono8", 1024, 1024, 1024, pixels.data());
            }));
  EXPECT_TRUE(in_segment(ours.data.data()));
}

TEST(PointCloud2Modifier, modifies_like_the_library) {
  for (const std::uint32_t height : {0u, 1u, 2u, 5u}) {
    for (const std::uint32_t width : {0u, 1u, 4u}) {
      SCOPED_TRACE(std::to_string(height) + " x " + std::to_string(width));
      Clouds clouds;
      clouds.stock.height = clouds.ours.height = height;
      clouds.stock.width = clouds.ours.width = width;
      modify(clouds, [](auto& m) {
        m.setPointCloud2Fields(3, "x", 1, Field::FLOAT32, "n", 3, Field::UINT16, "d", 1, Field::FLOAT64);
      });
      modify(clouds, [](auto& m) { m.resize(7); });
      modify(clouds, [](auto& m) { m.reserve(70); });
      modify(clouds, [](auto& m) { m.setPointCloud2FieldsByString(2, "xyz", "rgba"); });
      modify(clouds, [](auto& m) { m.resize(9); });
      modify(clouds, [](auto& m) { m.clear(); });
      modify(clouds, [](auto& m) { m.resize(2); });
    }
  }
}

/// What a node does with a cloud: describe its fields, resize it, write each point.
template <class Modifier, template <class> class Iterator, class Cloud>
void build(Cloud& cloud, std::size_t points) {
  Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(2, "xyz", "rgb");
  modifier.resize(points);
  Iterator<float> x(cloud, "x"), y(cloud, "y");
  Iterator<std::uint8_t> red(cloud, "r");
  for (float n = 0; x != x.end(); ++x, ++y, ++red, ++n) *x = n, *y = 2 * n, *red = 3;
}

TEST(PointCloud2Modifier, a_cloud_is_built_in_one_place_like_the_librarys) {
  const std::size_t points = 10000, size = points * 32;
  test::FakePublisher publisher;
  Clouds clouds;
  ASSERT_TRUE(message::allocate(clouds.ours, publisher.memory()));
  const auto librarys = test::places_for(size, publisher.test_memory, [&] {
    build< ::sensor_msgs::PointCloud2Modifier, ::sensor_msgs::PointCloud2Iterator>(clouds.stock, points);
  });
  const auto ours = test::places_for(size, publisher.test_memory, [&] {
    build<sensor_msgs::PointCloud2Modifier, sensor_msgs::PointCloud2Iterator>(clouds.ours, points);
    message::Encoded encoded;
    ASSERT_TRUE(message::encode(clouds.ours, publisher.test_memory, encoded));
    EXPECT_EQ(0u, encoded.copied_bytes) << "publishing copies nothing more";
  });
  clouds.expect_equal();
  EXPECT_EQ(1u, librarys);
  EXPECT_EQ(1u, ours);
}

TEST(PointCloud2Modifier, refuses_unknown_names) {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  EXPECT_THROW(modifier.setPointCloud2FieldsByString(1, "hsv"), std::runtime_error);
}

class PointIterators : public ::testing::Test {
 protected:
  void SetUp() override {
    modify(clouds_, [](auto& m) {
      m.setPointCloud2FieldsByString(2, "xyz", "rgb");
      m.resize(50);
    });
  }

  Clouds clouds_;
};

TEST_F(PointIterators, write_like_the_librarys) {
  const auto fill = [](auto x, auto red, auto blue) {
    for (float n = 1; x != x.end(); ++x, ++red, ++blue, ++n) {
      *x = n;
      x[2] = n / 2;
      *red = static_cast<std::uint8_t>(n);
      *blue = 9;
    }
  };
  fill(::sensor_msgs::PointCloud2Iterator<float>(clouds_.stock, "x"),
       ::sensor_msgs::PointCloud2Iterator<std::uint8_t>(clouds_.stock, "r"),
       ::sensor_msgs::PointCloud2Iterator<std::uint8_t>(clouds_.stock, "b"));
  fill(sensor_msgs::PointCloud2Iterator<float>(clouds_.ours, "x"),
       sensor_msgs::PointCloud2Iterator<std::uint8_t>(clouds_.ours, "r"),
       sensor_msgs::PointCloud2Iterator<std::uint8_t>(clouds_.ours, "b"));
  clouds_.expect_equal();
}

TEST_F(PointIterators, read_and_step_like_the_librarys) {
  std::uint8_t next = 0;
  for (std::uint8_t& byte : clouds_.ours.data) byte = ++next;
  const sensor_msgs::PointCloud2& cloud = clouds_.ours;
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> green(cloud, "g");
  EXPECT_EQ(cloud.data[16 + 1], *green);
  green += 2;
  sensor_msgs::PointCloud2ConstIterator<std::uint8_t> later = green + 3;
  EXPECT_EQ(cloud.data[32 * 5 + 17], *later);
  green = later;
  EXPECT_FALSE(green != later);
  ::sensor_msgs::PointCloud2ConstIterator<std::uint8_t>& as_stock = green;
  EXPECT_EQ(*later, *as_stock);
}

TEST_F(PointIterators, refuse_unknown_fields) {
  EXPECT_THROW(sensor_msgs::PointCloud2Iterator<float>(clouds_.ours, "w"), std::runtime_error);
}

TEST_F(PointIterators, writing_after_publishing_reaches_nobody) {
  test::FakePublisher publisher;
  ASSERT_TRUE(message::allocate(clouds_.ours, publisher.memory()));
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(clouds_.ours, publisher.test_memory, encoded));
  const auto view = message::stock_view(clouds_.ours, encoded);
  sensor_msgs::PointCloud2Iterator<float> x(clouds_.ours, "x");
  *x = 77;
  EXPECT_EQ(clouds_.stock, *view);
}

}  // namespace
}  // namespace tzc

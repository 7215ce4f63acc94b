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

TEST(FillImage, FillsLikeTheLibrary) {
  const std::vector<std::uint8_t> pixels(20 * 10, 7);
  ::sensor_msgs::Image stock;
  sensor_msgs::Image ours;
  EXPECT_TRUE(::sensor_msgs::fillImage(stock, "mono8", 10, 16, 20, pixels.data()));
  EXPECT_TRUE(sensor_msgs::fillImage(ours, "mono8", 10, 16, 20, pixels.data()));
  EXPECT_EQ(stock, message::to_stock(ours));
  sensor_msgs::clearImage(ours);
  EXPECT_TRUE(ours.data.empty());
}

TEST(FillImage, CopiesOnceLikeTheLibrary) {
  const std::vector<std::uint8_t> pixels(1 << 20, 7);
  test::FakePublisher publisher;
  sensor_msgs::Image ours;
  ASSERT_TRUE(message::allocate(ours, publisher.memory()));
  EXPECT_EQ(1u, test::places_for(pixels.size(), *publisher.test_memory, [&] {
              sensor_msgs::fillImage(ours, "mono8", 1024, 1024, 1024, pixels.data());
            }));
  EXPECT_TRUE(in_segment(ours.data.data()));
}

TEST(PointCloud2Modifier, ModifiesLikeTheLibrary) {
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

TEST(PointCloud2Modifier, RefusesUnknownNames) {
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

TEST_F(PointIterators, WriteLikeTheLibrarys) {
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

TEST_F(PointIterators, ReadAndStepLikeTheLibrarys) {
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

TEST_F(PointIterators, RefuseUnknownFields) {
  EXPECT_THROW(sensor_msgs::PointCloud2Iterator<float>(clouds_.ours, "w"), std::runtime_error);
}

TEST_F(PointIterators, WritingAfterPublishingReachesNobody) {
  test::FakePublisher publisher;
  ASSERT_TRUE(message::allocate(clouds_.ours, publisher.memory()));
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(clouds_.ours, *publisher.test_memory, encoded));
  const auto view = message::stock_view(clouds_.ours, encoded);
  sensor_msgs::PointCloud2Iterator<float> x(clouds_.ours, "x");
  *x = 77;
  EXPECT_EQ(clouds_.stock, *view);
}

}  // namespace
}  // namespace tzc

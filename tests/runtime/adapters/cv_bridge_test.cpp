// SPDX-License-Identifier: BSD-3-Clause
// tzc::cv_bridge against cv_bridge itself: the same messages, no more copies.
#include <sensor_msgs/image_encodings.h>
#include <tzc/cv_bridge.h>
#include <tzc/message.h>

#include "copies.h"

namespace tzc {
namespace {

::cv_bridge::CvImage picture(const std::string& encoding, int rows = 48, int columns = 64) {
  ::cv_bridge::CvImage image;
  image.header.frame_id = "camera";
  image.header.stamp = ros::Time(3, 4);
  image.encoding = encoding;
  image.image = cv::Mat(rows, columns, ::cv_bridge::getCvType(encoding));
  cv::randu(image.image, 0, 200);
  return image;
}

class CvBridge : public ::testing::Test {
 protected:
  static void expect_same(const ::cv_bridge::CvImage& image, const sensor_msgs::Image& message) {
    EXPECT_EQ(*image.toImageMsg(), message::to_stock(message));
  }

  test::FakePublisher publisher_;
};

TEST_F(CvBridge, builds_the_librarys_message) {
  namespace enc = ::sensor_msgs::image_encodings;
  for (const auto& encoding :
       {enc::BGR8, enc::RGBA8, enc::MONO8, enc::MONO16, enc::TYPE_32FC1, enc::TYPE_64FC4}) {
    SCOPED_TRACE(encoding);
    const auto image = picture(encoding);
    const auto message = cv_bridge::to_image_msg(image, publisher_);
    expect_same(image, *message);
    EXPECT_TRUE(in_segment(message->data.data()));
  }
}

TEST_F(CvBridge, takes_parts_of_images) {
  auto image = picture("bgr8");
  image.image = image.image(cv::Rect(5, 6, 20, 10));
  ASSERT_FALSE(image.image.isContinuous());
  expect_same(image, *cv_bridge::to_image_msg(image, publisher_));
}

TEST_F(CvBridge, takes_pointers_and_fills_given_messages) {
  const auto image = boost::make_shared<const ::cv_bridge::CvImage>(picture("bgr8"));
  expect_same(*image, *cv_bridge::to_image_msg(image, publisher_));
  expect_same(*image, *cv_bridge::to_image_msg(image, publisher_.test_memory));
  sensor_msgs::Image message;
  cv_bridge::to_image_msg(image, message);
  expect_same(*image, message);
}

TEST_F(CvBridge, an_empty_image_is_an_empty_message) {
  ::cv_bridge::CvImage image;
  image.encoding = "bgr8";
  EXPECT_TRUE(cv_bridge::to_image_msg(image, publisher_)->data.empty());
}

TEST_F(CvBridge, copies_once_like_the_library) {
  const auto image = picture("bgr8", 480, 640);
  const std::size_t size = 480 * 640 * 3;
  sensor_msgs::ImagePtr message;
  const auto& memory = publisher_.test_memory;
  const auto librarys = test::places_for(size, memory, [&] { image.toImageMsg(); });
  const auto ours = test::places_for(size, memory, [&] {
    message = cv_bridge::to_image_msg(image, publisher_);
    message::Encoded encoded;
    ASSERT_TRUE(message::encode(*message, memory, encoded));
    EXPECT_EQ(0u, encoded.copied_bytes) << "publishing copies nothing more";
  });
  EXPECT_EQ(1u, librarys);
  EXPECT_EQ(1u, ours);
}

TEST_F(CvBridge, a_reused_message_gets_fresh_memory_after_publishing) {
  sensor_msgs::Image message;
  ASSERT_TRUE(message::allocate(message, publisher_.memory()));
  const auto first = picture("bgr8"), second = picture("bgr8");
  cv_bridge::to_image_msg(first, message);
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(message, publisher_.test_memory, encoded));
  const auto view = message::stock_view(message, encoded);
  cv_bridge::to_image_msg(second, message);
  EXPECT_EQ(*first.toImageMsg(), *view);
  expect_same(second, message);
}

TEST_F(CvBridge, draws_into_the_message) {
  const auto image = picture("bgr8");
  sensor_msgs::Image message;
  ASSERT_TRUE(message::allocate(message, publisher_.memory()));
  message.header = image.header;
  message.encoding = "bgr8";
  message.height = 48;
  message.width = 64;
  message.step = 64 * 3;
  message.data.resize(48 * 64 * 3, uninitialized);
  image.image.copyTo(cv_bridge::mat(message));
  expect_same(image, message);
  EXPECT_EQ(message.data.data(), cv_bridge::mat(message).data);
}

TEST_F(CvBridge, copies_a_message_as_the_library_does) {
  for (const char* encoding : {"bgr8", "mono8", "mono16", "rgba8"}) {
    const auto stock = picture(encoding).toImageMsg();
    const sensor_msgs::Image message(*stock);
    for (const char* wanted : {"", encoding, "bgr8", "mono8"}) {
      const auto expected = ::cv_bridge::toCvCopy(stock, wanted);
      const auto copy = cv_bridge::toCvCopy(message, wanted);
      EXPECT_EQ(*expected->toImageMsg(), *copy->toImageMsg()) << encoding << " as " << wanted;
      EXPECT_NE(copy->image.data, message.data.data()) << "a copy";
    }
  }
}

TEST_F(CvBridge, copies_a_message_by_pointer_and_of_the_other_byte_order) {
  const auto stock = picture("mono16").toImageMsg();
  stock->is_bigendian = !stock->is_bigendian;
  const auto message = boost::make_shared<sensor_msgs::Image>(*stock);
  EXPECT_EQ(*::cv_bridge::toCvCopy(stock)->toImageMsg(), *cv_bridge::toCvCopy(message)->toImageMsg());
  const sensor_msgs::ImageConstPtr read_only = message;
  EXPECT_EQ(*::cv_bridge::toCvCopy(stock)->toImageMsg(), *cv_bridge::toCvCopy(read_only)->toImageMsg());
}

TEST_F(CvBridge, copies_no_message_that_is_smaller_than_it_says) {
  sensor_msgs::Image message(*picture("bgr8").toImageMsg());
  message.data.pop_back();
  EXPECT_THROW(cv_bridge::toCvCopy(message), ::cv_bridge::Exception);
}

TEST_F(CvBridge, reading_a_published_message_copies_no_more_than_the_library) {
  sensor_msgs::Image message(*picture("bgr8").toImageMsg());
  message::Encoded encoded;
  ASSERT_TRUE(message::encode(message, publisher_.test_memory, encoded));
  const std::uint8_t* const before = static_cast<const sensor_msgs::Image&>(message).data.data();
  cv_bridge::toCvCopy(message);
  EXPECT_EQ(before, static_cast<const sensor_msgs::Image&>(message).data.data());
}

TEST_F(CvBridge, refuses_a_matrix_larger_than_its_data) {
  sensor_msgs::Image message;
  message.encoding = "bgr8";
  message.height = message.width = 10;
  message.step = 30;
  message.data.resize(299);
  EXPECT_THROW(cv_bridge::mat(message), ::cv_bridge::Exception);
  message.data.resize(300);
  EXPECT_NO_THROW(cv_bridge::mat(message));
  message.step = 29;
  EXPECT_THROW(cv_bridge::mat(message), ::cv_bridge::Exception);
}

}  // namespace
}  // namespace tzc

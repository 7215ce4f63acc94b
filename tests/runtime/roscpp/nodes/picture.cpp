// SPDX-License-Identifier: BSD-3-Clause
/// A type of its own that ROS knows as sensor_msgs/Image by a hand-written serializer, which writes byte by
/// byte what gencpp's writes as one array: published, or listened to, with a line for each (image_line.h).
///
/// Private parameters: role (talker, listener). Talker: topic_type (picture, image: what the topic is
/// advertised for), way (reference, pointer, view: an image instead, by its stock view), count.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>

#include <boost/make_shared.hpp>
#include <string>
#include <vector>

#include "image_line.h"

namespace {

struct Picture {
  std_msgs::Header header;
  std::vector<std::uint8_t> pixels;
};

}  // namespace

namespace ros {
namespace message_traits {

template <>
struct MD5Sum<Picture> : MD5Sum<sensor_msgs::Image> {
  static const char* value(const Picture&) { return MD5Sum<sensor_msgs::Image>::value(); }
  using MD5Sum<sensor_msgs::Image>::value;
};
template <>
struct DataType<Picture> : DataType<sensor_msgs::Image> {
  static const char* value(const Picture&) { return DataType<sensor_msgs::Image>::value(); }
  using DataType<sensor_msgs::Image>::value;
};
template <>
struct Definition<Picture> : Definition<sensor_msgs::Image> {
  static const char* value(const Picture&) { return Definition<sensor_msgs::Image>::value(); }
  using Definition<sensor_msgs::Image>::value;
};
template <>
struct HasHeader<Picture> : TrueType {};

}  // namespace message_traits
namespace serialization {

template <>
struct Serializer<Picture> {
  template <class Stream>
  static void write(Stream& stream, const Picture& picture) {
    const auto size = static_cast<std::uint32_t>(picture.pixels.size());
    stream.next(picture.header);
    stream.next(std::uint32_t{1});
    stream.next(size);
    stream.next(std::string("mono8"));
    stream.next(std::uint8_t{0});
    stream.next(size);
    stream.next(size);
    for (const std::uint8_t pixel : picture.pixels) stream.next(pixel);
  }
  template <class Stream>
  static void read(Stream& stream, Picture& picture) {
    sensor_msgs::Image rest;
    std::uint32_t size;
    stream.next(picture.header);
    stream.next(rest.height);
    stream.next(rest.width);
    stream.next(rest.encoding);
    stream.next(rest.is_bigendian);
    stream.next(rest.step);
    stream.next(size);
    picture.pixels.resize(size);
    for (std::uint8_t& pixel : picture.pixels) stream.next(pixel);
  }
  static std::uint32_t serializedLength(const Picture& picture) {
    return serializationLength(picture.header) +
           static_cast<std::uint32_t>(picture.pixels.size() + 5 * 4 + 5 + 1);
  }
};

}  // namespace serialization
}  // namespace ros

namespace {

constexpr std::size_t kPixels = 5000;

Picture make_picture(std::uint32_t number) {
  Picture picture;
  picture.header.frame_id = std::to_string(number);
  picture.header.stamp = ros::Time::now();
  picture.pixels.resize(kPixels);
  tzc_test::fill_pattern(picture.pixels.data(), kPixels, number);
  return picture;
}

void publish(const tzc::Publisher& publisher, const std::string& way, std::uint32_t number) {
  if (way == "view") {
    tzc::sensor_msgs::Image image;
    publisher.allocate(image);
    tzc_test::fill_image(image, number, kPixels);
    publisher.publish(publisher.stock_view(image));
  } else if (way == "pointer") {
    publisher.publish(boost::make_shared<Picture>(make_picture(number)));
  } else {
    publisher.publish(make_picture(number));
  }
}

void talk(ros::NodeHandle& node, const ros::NodeHandle& options) {
  const bool for_pictures = options.param<std::string>("topic_type", "picture") == "picture";
  const tzc::Publisher publisher = for_pictures ? tzc::advertise<Picture>(node, "image", 100)
                                                : tzc::advertise<tzc::sensor_msgs::Image>(node, "image", 100);
  while (ros::ok() && publisher.getNumSubscribers() == 0) ros::WallDuration(0.002).sleep();
  ros::WallDuration(0.5).sleep();
  for (int number = 0; ros::ok() && number < options.param("count", 20); ++number)
    publish(publisher, options.param<std::string>("way", "reference"), static_cast<std::uint32_t>(number));
  ros::WallDuration(0.5).sleep();
  std::printf("{\"copied_bytes\": %llu}\n", (unsigned long long)publisher.statistics().copied_bytes);
  std::fflush(stdout);
}

void take(const boost::shared_ptr<Picture const>& picture) {
  sensor_msgs::Image image;
  tzc_test::fill_image(image, 0, picture->pixels.size());
  image.header = picture->header;
  image.data = picture->pixels;
  tzc_test::print_image(image);
}

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "picture");
  ros::NodeHandle node, options("~");
  if (options.param<std::string>("role", "talker") == "talker") {
    talk(node, options);
    return 0;
  }
  const ros::Subscriber subscriber = tzc::subscribe(node, "image", 100, take);
  ros::spin();
}

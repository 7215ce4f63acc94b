// SPDX-License-Identifier: BSD-3-Clause
/// Publishes images on "image" as a port that went wrong would, and as one that is right.
///
/// Private parameters: mode, count, bytes, shared (subscribers on shared memory to wait for).
///   published   writes through a pointer that it took before publish
///   replaced    writes through a pointer that it took before allocate
///   member      one message for all publishes, filled through it each time: right
///   fresh       a message for each publish: right
///   growing     push_back and an array that stays empty for a while, after allocate: right
#include <ros/ros.h>
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>
#include <tzc/sensor_msgs/LaserScan.h>

#include <algorithm>
#include <string>

#include "image_line.h"

namespace {

using tzc::sensor_msgs::Image;

__attribute__((noinline)) void write_late(std::uint8_t* kept, std::size_t size) {
  std::fill(kept, kept + size, std::uint8_t{0});
}

class LateWriter {
 public:
  LateWriter(ros::NodeHandle node, const ros::NodeHandle& options)
      : mode_(options.param<std::string>("mode", "published")),
        bytes_(static_cast<std::size_t>(options.param("bytes", 100000))),
        images_(tzc::advertise<Image>(node, "image", 100)),
        scans_(tzc::advertise<tzc::sensor_msgs::LaserScan>(node, "scan", 100)),
        sees_scans_(node.subscribe<sensor_msgs::LaserScan>(
            "scan", 1, [this](const sensor_msgs::LaserScanConstPtr& scan) { last_ = scan; })) {}

  int shared() const { return static_cast<int>(images_.statistics().shared_subscribers); }

  void publish(std::uint32_t number) {
    if (mode_ == "published") publish_and_write(number);
    if (mode_ == "replaced") write_what_was_replaced(number);
    if (mode_ == "member") publish_filled(member_, number);
    if (mode_ == "fresh") publish_filled(*boost::make_shared<Image>(), number);
    if (mode_ == "growing") publish_growing(number);
  }

 private:
  void publish_filled(Image& image, std::uint32_t number) {
    images_.allocate(image);
    tzc_test::fill_image(image, number, bytes_);
    images_.publish(image);
  }

  void publish_and_write(std::uint32_t number) {
    Image image;
    images_.allocate(image);
    tzc_test::fill_image(image, number, bytes_);
    std::uint8_t* const kept = image.data.data();
    images_.publish(image);
    write_late(kept, bytes_);
  }

  // What is published is right all the same: it is filled through the message once more.
  void write_what_was_replaced(std::uint32_t number) {
    Image image;
    image.data.resize(bytes_);
    std::uint8_t* const kept = image.data.data();
    images_.allocate(image);
    write_late(kept, bytes_);
    tzc_test::fill_image(image, number, bytes_);
    images_.publish(image);
  }

  void publish_growing(std::uint32_t number) {
    publish_filled(member_, number);
    scan_.ranges.clear();
    scan_.intensities.clear();
    scan_.ranges.reserve(2000);
    scan_.intensities.reserve(2000);
    scans_.allocate(scan_);
    for (int i = 0; i < 2000; ++i) scan_.ranges.push_back(static_cast<float>(i));
    scans_.publish(scan_);
    for (int i = 0; i < 2000; ++i) scan_.intensities.push_back(static_cast<float>(i));
    scans_.publish(scan_);
    scan_.ranges[7] = 1;
    scans_.allocate(scan_);
    scan_.intensities[7] = 1;
    scans_.publish(scan_);
    scans_.allocate(scan_);
    scan_.intensities[8] = 2;
    scans_.publish(scan_);
    scan_.ranges[8] = 2;
  }

  const std::string mode_;
  const std::size_t bytes_;
  tzc::Publisher images_, scans_;
  const ros::Subscriber sees_scans_;  // in this process: its scans are shared, too
  sensor_msgs::LaserScanConstPtr last_;
  Image member_;
  tzc::sensor_msgs::LaserScan scan_;
};

}  // namespace

int main(int argc, char** argv) {
  ros::init(argc, argv, "late_writer");
  ros::NodeHandle node, options("~");
  LateWriter writer(node, options);
  const int count = options.param("count", 20), shared = options.param("shared", 2);
  while (ros::ok() && writer.shared() < shared) ros::WallDuration(0.002).sleep();
  for (int number = 0; ros::ok() && number < count; ++number) {
    writer.publish(static_cast<std::uint32_t>(number));
    ros::WallDuration(0.01).sleep();
  }
  ros::WallDuration(1).sleep();
}

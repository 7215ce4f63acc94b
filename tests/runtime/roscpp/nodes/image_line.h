// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <ros/time.h>
#include <sensor_msgs/Image.h>
#include <tzc/memory.h>

#include <cstdio>
#include <cstdlib>
#include <string>

#include "pattern.h"

namespace tzc_test {

/// Do its fields fit each other, as a talker fills them?
inline bool is_consistent(const sensor_msgs::Image& image) {
  const std::uint32_t channels = image.encoding == "bgr8" ? 3 : 1;
  return (image.encoding == "mono8" || image.encoding == "bgr8") && image.is_bigendian == 0 &&
         image.step == image.width * channels &&
         image.data.size() == std::size_t(image.step) * image.height && image.height > 0 &&
         !image.data.empty() && !image.header.stamp.isZero();
}

/// One line of JSON about an image: number, seq, whether all fields and bytes are right, whether the bytes
/// lie in a shared segment. `extra`: more members, each with a comma behind it.
inline void print_image(const sensor_msgs::Image& image, const std::string& extra = std::string()) {
  const auto number = static_cast<std::uint32_t>(std::atoi(image.header.frame_id.c_str()));
  const double latency = (ros::Time::now() - image.header.stamp).toSec() * 1e6;
  const bool right = is_consistent(image) && has_pattern(image.data.data(), image.data.size(), number);
  const bool shared = tzc::in_segment(image.data.data());
  std::printf("{%s\"number\": %u, \"seq\": %u, \"right\": %s, \"shared\": %s, \"latency_us\": %.1f}\n",
              extra.c_str(), number, image.header.seq, right ? "true" : "false", shared ? "true" : "false",
              latency);
  std::fflush(stdout);
}

template <class Image>
void fill_image(Image& image, std::uint32_t number, std::size_t bytes) {
  image.header.frame_id = std::to_string(number);
  image.height = 1;
  image.width = static_cast<std::uint32_t>(bytes);
  image.step = image.width;
  image.encoding = "mono8";
  image.data.resize(bytes);
  fill_pattern(image.data.data(), bytes, number);
  image.header.stamp = ros::Time::now();
}

}  // namespace tzc_test

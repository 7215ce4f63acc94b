// SPDX-License-Identifier: BSD-3-Clause
// Headers of packages that were written for old compilers call nullptr NULL, as opencv_apps' do. What stands behind them has to compile.
#include <gtest/gtest.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define nullptr NULL
#include <tzc/ros.h>
#include <tzc/sensor_msgs/Image.h>
#undef nullptr

TEST(PublicHeaders, compile_where_nullptr_is_a_macro) {
  tzc::sensor_msgs::Image image;
  image.data.assign(3, 7);
  EXPECT_FALSE(tzc::Publisher());
  EXPECT_EQ(7, image.data.back());
}

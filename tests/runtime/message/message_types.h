// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <geometry_msgs/PoseStamped.h>
#include <gtest/gtest.h>
#include <nav_msgs/OccupancyGrid.h>
#include <nav_msgs/Path.h>
#include <sensor_msgs/CameraInfo.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/JoyFeedbackArray.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/MultiEchoLaserScan.h>
#include <sensor_msgs/PointCloud.h>
#include <sensor_msgs/PointCloud2.h>
#include <std_msgs/Float64MultiArray.h>
#include <std_msgs/String.h>
#include <stereo_msgs/DisparityImage.h>
#include <trajectory_msgs/JointTrajectory.h>
#include <visualization_msgs/InteractiveMarker.h>
#include <visualization_msgs/MarkerArray.h>

namespace tzc {
namespace test {

// Flat and nested, with and without header, arrays of padded and of simple elements, none at all.
using MessageTypes =
    ::testing::Types<::geometry_msgs::PoseStamped, ::nav_msgs::OccupancyGrid, ::nav_msgs::Path,
                     ::sensor_msgs::CameraInfo, ::sensor_msgs::Image, ::sensor_msgs::JoyFeedbackArray,
                     ::sensor_msgs::LaserScan, ::sensor_msgs::MultiEchoLaserScan, ::sensor_msgs::PointCloud,
                     ::sensor_msgs::PointCloud2, ::std_msgs::Float64MultiArray, ::std_msgs::String,
                     ::stereo_msgs::DisparityImage, ::trajectory_msgs::JointTrajectory,
                     ::visualization_msgs::InteractiveMarker, ::visualization_msgs::MarkerArray>;

}  // namespace test
}  // namespace tzc

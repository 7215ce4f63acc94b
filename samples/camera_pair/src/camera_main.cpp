// SPDX-License-Identifier: BSD-3-Clause
#include "camera_node.h"

int main(int argc, char** argv) {
  ros::init(argc, argv, "camera_node");
  camera_pair::CameraNode node{ros::NodeHandle(), ros::NodeHandle("~")};
  ros::spin();
}

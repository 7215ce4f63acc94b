// SPDX-License-Identifier: BSD-3-Clause
// Code of another package, which advertises images.
#pragma once
#include <image_transport/image_transport.h>
namespace other {
class ImageNodelet {
 protected:
  image_transport::Publisher advertiseImage(ros::NodeHandle&, const std::string&, int) { return {}; }
  image_transport::CameraPublisher advertiseCamera(ros::NodeHandle&, const std::string&, int) { return {}; }
};
}  // namespace other

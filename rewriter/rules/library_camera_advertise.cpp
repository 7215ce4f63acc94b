// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = advertiseCamera(nh, "image", 10);  // of a library's base class
/// After:   pub = tzc::image_transport::attach_publisher(advertiseCamera(nh, "image", 10));
const LibraryAdvertise library_camera_advertise{"library-camera-advertise",
                                                "image_transport::CameraPublisher",
                                                "image_transport::ImageTransport",
                                                false,
                                                "tzc::image_transport::attach_publisher",
                                                "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules

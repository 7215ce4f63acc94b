// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  pub = transport.advertiseCamera("image", 10);  // of a publisher that stays what it is
/// After:   pub = tzc::image_transport::attached(transport.advertiseCamera("image", 10));
const AttachedAdvertise attached_camera_advertise{"attached-camera-advertise",
                                                  "image_transport::CameraPublisher", false,
                                                  "tzc::image_transport::attached", "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules

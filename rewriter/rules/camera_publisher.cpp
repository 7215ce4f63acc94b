// SPDX-License-Identifier: BSD-3-Clause
#include "rules/rules.h"

namespace tzc::rewriter::rules {

/// Before:  image_transport::CameraPublisher pub;
/// After:   tzc::image_transport::CameraPublisher pub;
const ClassRename camera_publisher{"camera-publisher", ClassRename::Role::publisher,
                                   "image_transport::CameraPublisher",
                                   "tzc::image_transport::CameraPublisher", "tzc/image_transport.h"};

}  // namespace tzc::rewriter::rules

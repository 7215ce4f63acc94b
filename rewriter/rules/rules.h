// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "rules/rule.h"

namespace tzc::rewriter::rules {

// One per file, in the order of how often their patterns are met.
extern const ClassRename publisher, image_publisher, camera_publisher, filter_subscriber, subscriber_filter,
    point_cloud2_modifier, point_cloud2_iterator, point_cloud2_const_iterator;
extern const LibraryCall pcl_to_ros_msg, pcl_from_pcl, pcl_move_from_pcl, fill_image, clear_image,
    add_point_field, pcl_from_ros_msg, cv_copy_of_message;
extern const MethodCall advertise, image_advertise, camera_advertise, attached_publish,
    attached_image_publish, attached_camera_publish, subscribe, image_subscribe, camera_subscribe,
    cv_image_to_message, cv_image_into_message, laser_projection, kept_filter, kept_image_filter;
extern const LibraryAdvertise library_advertise, library_image_advertise, library_camera_advertise;
extern const AttachedAdvertise attached_advertise, attached_image_advertise, attached_camera_advertise;
extern const LibraryTransport attached_laser_advertise;

}  // namespace tzc::rewriter::rules

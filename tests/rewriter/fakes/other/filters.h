// SPDX-License-Identifier: BSD-3-Clause
// Code of another package, which has filters for its children.
#pragma once
#include <image_transport/subscriber_filter.h>
#include <message_filters/subscriber.h>
#include <sensor_msgs/PointCloud2.h>
namespace other {
class Filtering {
 protected:
  boost::shared_ptr<ros::NodeHandle> nh_;
  boost::shared_ptr<image_transport::ImageTransport> transport_;
  message_filters::Subscriber<sensor_msgs::PointCloud2> cloud_filter_;
  boost::shared_ptr<image_transport::SubscriberFilter> image_filter_;
  int queue_ = 3;
};
}  // namespace other

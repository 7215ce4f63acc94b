// SPDX-License-Identifier: BSD-3-Clause
#include <cv_bridge/cv_bridge.h>
#include <image_transport/simple_publisher_plugin.h>
#include <image_transport/simple_subscriber_plugin.h>
#include <sensor_msgs/CompressedImage.h>
#include <pluginlib/class_list_macros.hpp>

#include <opencv2/imgcodecs.hpp>
#include <string>

namespace jpeg_transport {

/// Publishes every image as JPEG, for subscribers of base_topic/compressed.
class JpegPublisher : public image_transport::SimplePublisherPlugin<sensor_msgs::CompressedImage> {
 public:
  std::string getTransportName() const override { return "compressed"; }

 protected:
  void publish(const sensor_msgs::Image& image, const PublishFn& publish_fn) const override {
    const cv_bridge::CvImageConstPtr bgr =
        cv_bridge::toCvShare(image, boost::shared_ptr<void const>(), "bgr8");
    sensor_msgs::CompressedImage compressed;
    compressed.header = image.header;
    compressed.format = image.encoding + "; jpeg compressed bgr8";
    cv::imencode(".jpg", bgr->image, compressed.data);
    publish_fn(compressed);
  }
};

class JpegSubscriber : public image_transport::SimpleSubscriberPlugin<sensor_msgs::CompressedImage> {
 public:
  std::string getTransportName() const override { return "compressed"; }

 protected:
  void internalCallback(const sensor_msgs::CompressedImageConstPtr& message,
                        const Callback& callback) override {
    const cv::Mat bgr = cv::imdecode(message->data, cv::IMREAD_COLOR);
    callback(cv_bridge::CvImage(message->header, "bgr8", bgr).toImageMsg());
  }
};

}  // namespace jpeg_transport

PLUGINLIB_EXPORT_CLASS(jpeg_transport::JpegPublisher, image_transport::PublisherPlugin)
PLUGINLIB_EXPORT_CLASS(jpeg_transport::JpegSubscriber, image_transport::SubscriberPlugin)

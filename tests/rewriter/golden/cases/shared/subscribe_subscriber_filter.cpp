// image_transport::SubscriberFilter.
#include <image_transport/subscriber_filter.h>

class Node {
 public:
  explicit Node(image_transport::ImageTransport& it) {
    filter_.subscribe(it, "image", 1, image_transport::TransportHints("raw"));
  }

 private:
  image_transport::SubscriberFilter filter_;
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// -  image_transport::SubscriberFilter filter_;
// +  tzc::image_transport::SubscriberFilter filter_;

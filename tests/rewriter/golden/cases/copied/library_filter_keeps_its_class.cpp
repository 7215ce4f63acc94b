// A base class of another package has the filters, and may register callbacks with them.
#include <other/filters.h>

class Crop : public other::Filtering {
 public:
  void start() {
    cloud_filter_.subscribe(*nh_, "cloud", queue_);
    this->image_filter_->subscribe(*transport_, "image", 1);
  }
};
//--- expected
// subscribe src/node.cpp:7 sensor_msgs/PointCloud2 copied 'cloud' TZC2009 what holds the filter cannot be given another type, and message_filters' own class gets a copy, since it may pass it on to a writer
// subscribe src/node.cpp:8 sensor_msgs/Image copied 'image' TZC2001 the callback is not known here, and pages that it writes to are copied
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/message_filters.h>
// -    cloud_filter_.subscribe(*nh_, "cloud", queue_);
// -    this->image_filter_->subscribe(*transport_, "image", 1);
// +    tzc::message_filters::subscribe(cloud_filter_, *nh_, "cloud", queue_);
// +    tzc::message_filters::subscribe(*this->image_filter_, *transport_, "image", 1);

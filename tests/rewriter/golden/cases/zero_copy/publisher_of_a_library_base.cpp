// A base class of another package advertises, and has the publishers. They stay what they are.
#include <other/library.h>
#include <sensor_msgs/CameraInfo.h>

class Child : public other::Server {
 public:
  void by_reference() {
    sensor_msgs::Image image;
    image.data.resize(10);
    map_pub_.publish(image);
    this->map_pub_.publish( image );
    if (!map_pubs_.empty()) map_pubs_[next()].publish(image);
  }
  void by_pointer() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
    image->data.resize(10);
    shared_pub_->publish(image);
    (map_pub_).publish(/* as it is */ image);
  }
  void light() {
    sensor_msgs::CameraInfo info;
    map_pub_.publish(info);
  }

 private:
  int next() { return ++next_; }
  int next_ = 0;
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy
// publish src/node.cpp:11 sensor_msgs/Image zero_copy
// publish src/node.cpp:12 sensor_msgs/Image zero_copy
// publish src/node.cpp:17 sensor_msgs/Image zero_copy
// publish src/node.cpp:18 sensor_msgs/Image zero_copy
// publish src/node.cpp:22 sensor_msgs/CameraInfo not_needed no array of it that shared memory can hold is filled
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    tzc::allocate(image);
// -    map_pub_.publish(image);
// -    this->map_pub_.publish( image );
// -    if (!map_pubs_.empty()) map_pubs_[next()].publish(image);
// +    tzc::publish(map_pub_, image);
// +    tzc::publish(this->map_pub_, image );
// +    if (!map_pubs_.empty()) tzc::publish(map_pubs_[next()], image);
// -    sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +    tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +    tzc::allocate(*image);
// -    shared_pub_->publish(image);
// -    (map_pub_).publish(/* as it is */ image);
// +    tzc::publish(*shared_pub_, image);
// +    tzc::publish((map_pub_), /* as it is */ image);

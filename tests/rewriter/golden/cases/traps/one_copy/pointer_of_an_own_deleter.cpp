// A deleter's pointer may be a class of the package, whose operators publish while a pointer into the data is there.
#include <cstring>
#include <map>
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node;
struct Source {
  struct Pointer {
    Source* at = nullptr;
    Source& operator*() const;
    Source* operator->() const { return &**this; }
    friend bool operator==(Pointer a, Pointer b) { return a.at == b.at; }
    friend bool operator!=(Pointer a, Pointer b) { return a.at != b.at; }
    Pointer() = default;
    Pointer(std::nullptr_t) {}
  };
  struct Deleter {
    typedef Pointer pointer;
    void operator()(Pointer) {}
  };
  unsigned char pixel = 0;
};

class Node {
 public:
  void send() { pub_.publish(image_); }
  void tick() {
    image_.data.assign(10000, 1);
    std::memcpy(&image_.data[0], &(*source_).pixel, 1);
    send();
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  std::unique_ptr<Source, Source::Deleter> source_;
};
Node* node = nullptr;
Source& Source::Pointer::operator*() const {
  if (node) node->send();
  return *at;
}
//--- expected
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is used after the message may have been published
// advertise src/node.cpp:38 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 1);

// An algorithm gets a function of the package in an object of a library, which keeps a pointer to an element.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <functional>
#include <set>
#include <vector>

struct Finder {
  uint8_t* last = nullptr;
  void operator()(uint8_t& x) { last = &x; }
};
struct Node {
  uint8_t* last = nullptr;
  bool visit(uint8_t& x) {
    last = &x;
    return true;
  }
};
static const uint8_t* seen;
struct Less {
  bool operator()(const uint8_t& a, const uint8_t& b) const {
    seen = &b;
    return a < b;
  }
};
struct Pixel {
  Pixel& operator=(const uint8_t& x) {
    seen = &x;
    return *this;
  }
};

void by_reference(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_reference", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  Finder finder;
  std::for_each(image.data.begin(), image.data.end(), std::ref(finder));
  pub.publish(image);
  *finder.last = 1;
}
void by_function(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_function", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t* last = nullptr;
  std::function<bool(uint8_t&)> is_mark = [&last](uint8_t& x) {
    last = &x;
    return true;
  };
  image.height = std::count_if(image.data.begin(), image.data.end(), is_mark);
  pub.publish(image);
  *last = 1;
}
void by_binder(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_binder", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  Node node;
  image.height = std::count_if(image.data.begin(), image.data.end(),
                               std::bind(&Node::visit, &node, std::placeholders::_1));
  pub.publish(image);
  *node.last = 1;
}
void by_closure(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_closure", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  uint8_t* last = nullptr;
  const auto keep = [&last](uint8_t& x) {
    last = &x;
    return true;
  };
  std::for_each(image.data.begin(), image.data.end(), std::cref(keep));
  pub.publish(image);
  *last = 1;
}
void by_order(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_order", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::set<uint8_t, Less> values;
  values.insert(image.data.begin(), image.data.end());
  pub.publish(image);
  *const_cast<uint8_t*>(seen) = 1;
}
void by_constructor(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_constructor", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  const std::set<uint8_t, Less> values(image.data.begin(), image.data.end());
  pub.publish(image);
  *const_cast<uint8_t*>(seen) = 1;
}
void by_assignment(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_assignment", 10);
  sensor_msgs::Image image;
  image.data.resize(100);
  std::vector<Pixel> pixels(100);
  std::copy(image.data.begin(), image.data.end(), pixels.begin());
  pub.publish(image);
  *const_cast<uint8_t*>(seen) = 1;
}
//--- expected
// advertise src/node.cpp:36 sensor_msgs/Image one_copy 'by_reference'
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'by_reference' TZC1003 a pointer into its data is passed to a function object
// advertise src/node.cpp:45 sensor_msgs/Image one_copy 'by_function'
// publish src/node.cpp:54 sensor_msgs/Image one_copy 'by_function' TZC1003 a pointer into its data is passed to a function object
// advertise src/node.cpp:58 sensor_msgs/Image one_copy 'by_binder'
// publish src/node.cpp:64 sensor_msgs/Image one_copy 'by_binder' TZC1003 a pointer into its data is passed to a function object
// advertise src/node.cpp:68 sensor_msgs/Image one_copy 'by_closure'
// publish src/node.cpp:77 sensor_msgs/Image one_copy 'by_closure' TZC1003 a pointer into its data is passed to a function object
// advertise src/node.cpp:81 sensor_msgs/Image one_copy 'by_order'
// publish src/node.cpp:86 sensor_msgs/Image one_copy 'by_order' TZC1003 a pointer into its data is passed to 'Less'
// advertise src/node.cpp:90 sensor_msgs/Image one_copy 'by_constructor'
// publish src/node.cpp:94 sensor_msgs/Image one_copy 'by_constructor' TZC1003 a pointer into its data is passed to 'Less'
// advertise src/node.cpp:98 sensor_msgs/Image one_copy 'by_assignment'
// publish src/node.cpp:103 sensor_msgs/Image one_copy 'by_assignment' TZC1003 a pointer into its data is passed to 'Pixel'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_reference", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_reference", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_function", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_function", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_binder", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_binder", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_closure", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_closure", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_order", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_order", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_constructor", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_constructor", 10);
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("by_assignment", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "by_assignment", 10);

// A library hands a message to code of the package that takes anything: no type and no flow in the source shows it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <functional>
#include <list>
#include <set>
#include <tuple>

unsigned char* kept;

struct Keep {
  template <class Message>
  Message& operator()(Message& message) const {
    kept = message.data.data();
    return message;
  }
};
struct Keeper {
  template <class Message>
  Keeper(Message& message) {
    kept = message.data.data();
  }
};
struct Order {
  template <class One, class Other>
  bool operator()(const One& one, const Other& other) const {
    kept = one->data.data();
    return one.get() < other.get();
  }
};

class Node {
 public:
  void found() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::find_if(&image, &image + 1, [](auto& one) { return (kept = one.data.data()) == nullptr; });
    found_pub_.publish(image);
    kept[0] = 1;
  }
  void invoked() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::invoke(Keep(), image);
    invoked_pub_.publish(image);
    kept[0] = 1;
  }
  void applied() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::apply([](auto& one) -> auto& { return kept = one.data.data(), one; }, std::tie(image));
    applied_pub_.publish(image);
    kept[0] = 1;
  }
  void deleted() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image, [](auto* one) { kept = one->data.data(); });
    image->data.resize(100);
    deleted_pub_.publish(image);
    image.reset();
    kept[0] = 1;
  }
  void removed() {
    const auto image = boost::make_shared<sensor_msgs::Image>();
    std::list<sensor_msgs::ImagePtr> images{image};
    image->data.resize(100);
    images.remove_if([](auto& one) { return (kept = one->data.data()) == nullptr; });
    removed_pub_.publish(image);
    kept[0] = 1;
  }
  void paired() {
    const auto image = boost::make_shared<sensor_msgs::Image>();
    image->data.resize(100);
    std::pair<sensor_msgs::ImagePtr, Keeper> pair(image, *image);
    paired_pub_.publish(image);
    kept[0] = 1;
  }
  void ordered() {
    const auto image = boost::make_shared<sensor_msgs::Image>();
    image->data.resize(100);
    std::set<sensor_msgs::ImagePtr, Order> images;
    images.insert(nullptr);
    images.insert(image);
    ordered_pub_.publish(image);
    kept[0] = 1;
  }
  void converted() {
    sensor_msgs::Image image;
    image.data.resize(100);
    std::find_if(&image, &image + 1, [](Keeper) { return true; });
    converted_pub_.publish(image);
    kept[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher found_pub_ = nh_.advertise<sensor_msgs::Image>("found", 1);
  ros::Publisher invoked_pub_ = nh_.advertise<sensor_msgs::Image>("invoked", 1);
  ros::Publisher applied_pub_ = nh_.advertise<sensor_msgs::Image>("applied", 1);
  ros::Publisher deleted_pub_ = nh_.advertise<sensor_msgs::Image>("deleted", 1);
  ros::Publisher removed_pub_ = nh_.advertise<sensor_msgs::Image>("removed", 1);
  ros::Publisher paired_pub_ = nh_.advertise<sensor_msgs::Image>("paired", 1);
  ros::Publisher ordered_pub_ = nh_.advertise<sensor_msgs::Image>("ordered", 1);
  ros::Publisher converted_pub_ = nh_.advertise<sensor_msgs::Image>("converted", 1);
};
//--- expected
// publish src/node.cpp:40 sensor_msgs/Image one_copy 'found' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:47 sensor_msgs/Image one_copy 'invoked' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:54 sensor_msgs/Image one_copy 'applied' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:60 sensor_msgs/Image one_copy 'deleted' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:69 sensor_msgs/Image one_copy 'removed' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:76 sensor_msgs/Image one_copy 'paired' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:85 sensor_msgs/Image one_copy 'ordered' TZC1001 a library may give it to a template that takes anything
// publish src/node.cpp:92 sensor_msgs/Image one_copy 'converted' TZC1001 a library may give it to a template that takes anything
// advertise src/node.cpp:98 sensor_msgs/Image one_copy 'found'
// advertise src/node.cpp:99 sensor_msgs/Image one_copy 'invoked'
// advertise src/node.cpp:100 sensor_msgs/Image one_copy 'applied'
// advertise src/node.cpp:101 sensor_msgs/Image one_copy 'deleted'
// advertise src/node.cpp:102 sensor_msgs/Image one_copy 'removed'
// advertise src/node.cpp:103 sensor_msgs/Image one_copy 'paired'
// advertise src/node.cpp:104 sensor_msgs/Image one_copy 'ordered'
// advertise src/node.cpp:105 sensor_msgs/Image one_copy 'converted'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher found_pub_ = nh_.advertise<sensor_msgs::Image>("found", 1);
// -  ros::Publisher invoked_pub_ = nh_.advertise<sensor_msgs::Image>("invoked", 1);
// -  ros::Publisher applied_pub_ = nh_.advertise<sensor_msgs::Image>("applied", 1);
// -  ros::Publisher deleted_pub_ = nh_.advertise<sensor_msgs::Image>("deleted", 1);
// -  ros::Publisher removed_pub_ = nh_.advertise<sensor_msgs::Image>("removed", 1);
// -  ros::Publisher paired_pub_ = nh_.advertise<sensor_msgs::Image>("paired", 1);
// -  ros::Publisher ordered_pub_ = nh_.advertise<sensor_msgs::Image>("ordered", 1);
// -  ros::Publisher converted_pub_ = nh_.advertise<sensor_msgs::Image>("converted", 1);
// +  tzc::Publisher found_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "found", 1);
// +  tzc::Publisher invoked_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "invoked", 1);
// +  tzc::Publisher applied_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "applied", 1);
// +  tzc::Publisher deleted_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "deleted", 1);
// +  tzc::Publisher removed_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "removed", 1);
// +  tzc::Publisher paired_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "paired", 1);
// +  tzc::Publisher ordered_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "ordered", 1);
// +  tzc::Publisher converted_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "converted", 1);

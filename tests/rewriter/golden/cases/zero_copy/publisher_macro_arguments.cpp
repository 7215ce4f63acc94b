// Arguments that macros write, or write a part of, keep their spelling.
//RUN: mem-size=1000
#include <node/config.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define TOPIC "image"
#define PREFIX "camera/"
#define QUEUE 10
#define NAME(x) "camera/" x
#define NAMED(x) "camera/" #x
#define SAME(x) x
#define LATCH true
#define SEVERAL(x, y) std::max(x, y)

class Node {
 public:
  explicit Node(ros::NodeHandle& nh) {
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(TOPIC, 10));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>("image", QUEUE));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>( TOPIC , QUEUE ));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(PREFIX "image", 2 * QUEUE));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>("image" TOPIC, QUEUE + 1, LATCH));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(NAME("image"), SAME(10)));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(NAMED(image), SAME(QUEUE), SAME(false)));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(SAME(NAME)("image"), SEVERAL(1, QUEUE)));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(CONFIG_TOPIC, CONFIG_QUEUE));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(std::string("camera/") + TOPIC, (QUEUE)));
    pubs_.push_back(nh.advertise<sensor_msgs::Image>(/* name */ TOPIC /* of it */, QUEUE /* long */));
  }
  void poll(std::size_t i) {
    sensor_msgs::Image image;
    image.data.resize(10);
    pubs_[i].publish(image);
  }

 private:
  std::vector<ros::Publisher> pubs_;
};
//--- include/node/config.h
#pragma once
#define CONFIG_TOPIC "configured"
#define CONFIG_QUEUE (5)
//--- expected
// advertise src/node.cpp:19 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:22 sensor_msgs/Image zero_copy 'camera/image'
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy 'imageimage'
// advertise src/node.cpp:24 sensor_msgs/Image zero_copy 'camera/image'
// advertise src/node.cpp:25 sensor_msgs/Image zero_copy 'camera/image'
// advertise src/node.cpp:26 sensor_msgs/Image zero_copy 'camera/image'
// advertise src/node.cpp:27 sensor_msgs/Image zero_copy 'configured'
// advertise src/node.cpp:28 sensor_msgs/Image zero_copy
// advertise src/node.cpp:29 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(TOPIC, 10));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>("image", QUEUE));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>( TOPIC , QUEUE ));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(PREFIX "image", 2 * QUEUE));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>("image" TOPIC, QUEUE + 1, LATCH));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(NAME("image"), SAME(10)));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(NAMED(image), SAME(QUEUE), SAME(false)));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(SAME(NAME)("image"), SEVERAL(1, QUEUE)));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(CONFIG_TOPIC, CONFIG_QUEUE));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(std::string("camera/") + TOPIC, (QUEUE)));
// -    pubs_.push_back(nh.advertise<sensor_msgs::Image>(/* name */ TOPIC /* of it */, QUEUE /* long */));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC, 10, 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", QUEUE, 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, TOPIC , QUEUE, 1000 ));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, PREFIX "image", 2 * QUEUE, 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, "image" TOPIC, QUEUE + 1, 1000, LATCH));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, NAME("image"), SAME(10), 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, NAMED(image), SAME(QUEUE), 1000, SAME(false)));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, SAME(NAME)("image"), SEVERAL(1, QUEUE), 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, CONFIG_TOPIC, CONFIG_QUEUE, 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, std::string("camera/") + TOPIC, (QUEUE), 1000));
// +    pubs_.push_back(tzc::advertise<tzc::sensor_msgs::Image>(nh, /* name */ TOPIC /* of it */, QUEUE, 1000 /* long */));
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pubs_[i].allocate(image);
// -  std::vector<ros::Publisher> pubs_;
// +  std::vector<tzc::Publisher> pubs_;

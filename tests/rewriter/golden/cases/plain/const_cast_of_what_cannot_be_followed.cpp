// A received message goes where it cannot be followed, and const is cast away from a message that comes from there.
#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>
#include <sensor_msgs/PointCloud2.h>

#include <cstring>
#include <list>
#include <thread>

class Thread {
 public:
  explicit Thread(ros::NodeHandle& nh) : subscriber_(nh.subscribe("image", 1, &Thread::onImage, this)) {}

 private:
  void onImage(const sensor_msgs::ImageConstPtr& image) { std::thread(&Thread::work, this, image).join(); }
  void work(const sensor_msgs::ImageConstPtr& image) {
    const_cast<sensor_msgs::Image&>(*image).data.push_back(1);
  }
  ros::Subscriber subscriber_;
};

class Union {
 public:
  explicit Union(ros::NodeHandle& nh) : subscriber_(nh.subscribe("scan", 1, &Union::onScan, this)) {}

 private:
  void onScan(const sensor_msgs::LaserScanConstPtr& scan) {
    union {
      const sensor_msgs::LaserScan* given;
      sensor_msgs::LaserScan* writable;
    } both;
    both.given = scan.get();
    both.writable->ranges.push_back(1);
  }
  ros::Subscriber subscriber_;
};

class Bytes {
 public:
  explicit Bytes(ros::NodeHandle& nh) : subscriber_(nh.subscribe("cloud", 1, &Bytes::onCloud, this)) {}

 private:
  void onCloud(const sensor_msgs::PointCloud2ConstPtr& cloud) {
    const sensor_msgs::PointCloud2* given = cloud.get();
    sensor_msgs::PointCloud2* writable;
    std::memcpy(&writable, &given, sizeof(given));
    writable->data.push_back(1);
  }
  ros::Subscriber subscriber_;
};

class Untyped {
 public:
  explicit Untyped(ros::NodeHandle& nh) : subscriber_(nh.subscribe("jpeg", 1, &Untyped::onImage, this)) {}

 private:
  void onImage(const sensor_msgs::CompressedImageConstPtr& image) {
    const void* const user = image.get();
    ((sensor_msgs::CompressedImage*)user)->data.push_back(1);
  }
  ros::Subscriber subscriber_;
};
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image plain 'image' TZC2002 const is cast away from a message that may be this one
// subscribe src/node.cpp:26 sensor_msgs/LaserScan plain 'scan' TZC2002 const is cast away from a message that may be this one
// subscribe src/node.cpp:42 sensor_msgs/PointCloud2 plain 'cloud' TZC2002 const is cast away from a message that may be this one
// subscribe src/node.cpp:56 sensor_msgs/CompressedImage plain 'jpeg' TZC2002 const is cast away from a message that may be this one

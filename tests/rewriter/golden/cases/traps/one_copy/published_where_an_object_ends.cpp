// A destructor publishes: at the end of a scope, at delete, or inside what a library does to what holds the object.
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Sender {
  ros::Publisher& pub;
  const sensor_msgs::Image& image;
  ~Sender() { pub.publish(image); }
};
void scopes(ros::NodeHandle& nh) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("scopes", 1);
  static sensor_msgs::Image image;
  image.data.assign(100, 1);
  {
    Sender sender{pub, image};
  }
  image.data[1] = 1;
  Sender sender{pub, image};
}

struct Later {
  ros::Publisher& pub;
  const sensor_msgs::Image& image;
  ~Later() { pub.publish(image); }
};
ros::Publisher late;
sensor_msgs::Image lasting;
void held(ros::NodeHandle& nh) {
  late = nh.advertise<sensor_msgs::Image>("held", 1);
  lasting.data.assign(100, 1);
  std::unique_ptr<Later> later(new Later{late, lasting});
  later.reset();
  lasting.data[1] = 1;
  later.reset(new Later{late, lasting});
}

struct Guard {
  ros::Publisher pub;
  sensor_msgs::Image image;
  ~Guard() { pub.publish(image); }
};
void own_message(ros::NodeHandle& nh) {
  Guard guard;
  guard.pub = nh.advertise<sensor_msgs::Image>("own_message", 1);
  guard.image.data.resize(100);
}
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image one_copy 'scopes' TZC1022 line 19 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:13 sensor_msgs/Image one_copy 'scopes'
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'held' TZC1022 line 35 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:31 sensor_msgs/Image one_copy 'held'
// publish src/node.cpp:42 sensor_msgs/Image zero_copy 'own_message'
// advertise src/node.cpp:46 sensor_msgs/Image zero_copy 'own_message'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher& pub;
// -  const sensor_msgs::Image& image;
// +  tzc::Publisher& pub;
// +  const tzc::sensor_msgs::Image& image;
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("scopes", 1);
// -  static sensor_msgs::Image image;
// +  static tzc::Publisher pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "scopes", 1);
// +  static tzc::sensor_msgs::Image image;
// -  ros::Publisher& pub;
// -  const sensor_msgs::Image& image;
// +  tzc::Publisher& pub;
// +  const tzc::sensor_msgs::Image& image;
// -ros::Publisher late;
// -sensor_msgs::Image lasting;
// +tzc::Publisher late;
// +tzc::sensor_msgs::Image lasting;
// -  late = nh.advertise<sensor_msgs::Image>("held", 1);
// +  late = tzc::advertise<tzc::sensor_msgs::Image>(nh, "held", 1);
// -  ros::Publisher pub;
// -  sensor_msgs::Image image;
// +  tzc::Publisher pub;
// +  tzc::sensor_msgs::Image image;
// -  guard.pub = nh.advertise<sensor_msgs::Image>("own_message", 1);
// +  guard.pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "own_message", 1);

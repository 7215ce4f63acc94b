// A C callback whose context is an object that begins with the message.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Frame {
  sensor_msgs::Image image;
  int id = 0;
};

void encode(void (*put)(void*, const uint8_t*, size_t), void* user);

void put(void* user, const uint8_t* bytes, size_t n) {
  sensor_msgs::Image* out = static_cast<sensor_msgs::Image*>(user);
  out->data.insert(out->data.end(), bytes, bytes + n);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  Frame frame;
  encode(put, &frame);
  pub.publish(frame.image);
}
//--- expected
// advertise src/node.cpp:18 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'image' TZC1001 a message that may be this one is cast from 'void *', which does not tell what lies there
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);

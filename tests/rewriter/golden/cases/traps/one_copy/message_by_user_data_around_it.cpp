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

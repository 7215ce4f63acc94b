// A closure that captured an array casts its const away.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/CompressedImage.h>

void on_jpeg(const sensor_msgs::CompressedImageConstPtr& jpeg) {
  auto trim = [&bytes = jpeg->data] { const_cast<std::vector<uint8_t>&>(bytes).resize(30000); };
  trim();
}

void run(ros::NodeHandle& nh) { ros::Subscriber jpegs = nh.subscribe("jpeg", 1, on_jpeg); }
//--- expected
// subscribe src/node.cpp:12 sensor_msgs/CompressedImage plain 'jpeg' TZC2002 const is cast away from an array that may be one of this message's

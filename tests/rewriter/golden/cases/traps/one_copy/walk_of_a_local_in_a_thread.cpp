// The message is local, and a thread that goes through its elements is there while it is published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image image;
  image.data.assign(1000, 7);
  int count = 0;
  std::thread reader([&] {
    for (uint8_t cell : image.data) count += cell;
  });
  pub.publish(image);
  reader.join();
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'image' TZC1003 another thread may publish or read it while this function reads its elements: no lock that both take keeps them apart
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);

// A generic callback makes an object with parentheses whose arguments depend on its own parameter.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <thread>

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  ros::Subscriber sub = nh.subscribe<sensor_msgs::Image>("input", 10, [&](const auto& in) {
    std::thread worker([in, &pub]() {
      sensor_msgs::Image copy = *in;
      pub.publish(copy);
    });
    worker.join();
  });
}
//--- expected

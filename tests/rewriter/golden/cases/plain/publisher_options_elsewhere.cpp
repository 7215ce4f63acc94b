// AdvertiseOptions that come from elsewhere name no type: left alone.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void run(ros::NodeHandle& nh, ros::AdvertiseOptions& options) {
  ros::Publisher pub = nh.advertise(options);
  sensor_msgs::Image image;
  image.data.resize(1);
  pub.publish(image);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/Image plain TZC1012 the options of this call say what is advertised
// publish src/node.cpp:9 sensor_msgs/Image plain TZC1012 the options of this call say what is advertised

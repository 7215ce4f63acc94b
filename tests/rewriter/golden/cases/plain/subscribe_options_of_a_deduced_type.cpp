// Options in a template that names their message nowhere: what suits one instance would be written for all.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

template <class Callback>
ros::Subscriber listen(ros::NodeHandle& nh, const std::string& topic, const Callback& callback) {
  ros::SubscribeOptions options = ros::SubscribeOptions::create(topic, 1, callback);
  return nh.subscribe(options);
}

int main() {
  ros::NodeHandle nh;
  boost::function<void(const sensor_msgs::ImageConstPtr&)> on_image;
  boost::function<void(const sensor_msgs::PointCloud2ConstPtr&)> on_cloud;
  ros::Subscriber image = listen(nh, "image", on_image);
  ros::Subscriber cloud = listen(nh, "cloud", on_cloud);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain TZC1007 the template does not name the message that its instances' options are for
// subscribe src/node.cpp:9 sensor_msgs/PointCloud2 plain TZC1007 the template does not name the message that its instances' options are for

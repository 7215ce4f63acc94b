// A cast that adds const, and one that takes it from a message that is the callback's own, harm nobody.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void process(const sensor_msgs::ImageConstPtr& image) { ROS_INFO("%zu bytes", image->data.size()); }

void look(const sensor_msgs::ImageConstPtr& image) { process(image); }
void draw(const sensor_msgs::ImagePtr& image) {
  image->data[0] = 1;
  process(boost::const_pointer_cast<const sensor_msgs::Image>(image));
}
void crop(const sensor_msgs::ImagePtr& image) {
  const sensor_msgs::ImageConstPtr shown = image;
  boost::const_pointer_cast<sensor_msgs::Image>(shown)->data.resize(1);
}
void clear(sensor_msgs::Image image) {
  const sensor_msgs::Image& shown = image;
  const_cast<sensor_msgs::Image&>(shown).data.clear();
}

int main() {
  ros::NodeHandle nh;
  ros::Subscriber looks = nh.subscribe("looked_at", 1, look);
  ros::Subscriber draws = nh.subscribe("drawn", 1, draw);
  ros::Subscriber crops = nh.subscribe("cropped", 1, crop);
  ros::Subscriber clears = nh.subscribe("cleared", 1, clear);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:23 sensor_msgs/Image shared 'looked_at'
// subscribe src/node.cpp:24 sensor_msgs/Image copied 'drawn' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:25 sensor_msgs/Image copied 'cropped' TZC2001 the callback may write to the message, so it gets a copy of its own
// subscribe src/node.cpp:26 sensor_msgs/Image copied 'cleared' TZC2001 the callback may write to the message, so it gets a copy of its own
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber looks = nh.subscribe("looked_at", 1, look);
// -  ros::Subscriber draws = nh.subscribe("drawn", 1, draw);
// -  ros::Subscriber crops = nh.subscribe("cropped", 1, crop);
// -  ros::Subscriber clears = nh.subscribe("cleared", 1, clear);
// +  ros::Subscriber looks = tzc::subscribe(nh, "looked_at", 1, look);
// +  ros::Subscriber draws = tzc::subscribe(nh, "drawn", 1, draw);
// +  ros::Subscriber crops = tzc::subscribe(nh, "cropped", 1, crop);
// +  ros::Subscriber clears = tzc::subscribe(nh, "cleared", 1, clear);

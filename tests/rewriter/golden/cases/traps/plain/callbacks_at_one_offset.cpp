// The two subscriptions stand in different files at one offset, and may have one topic.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace aa {
ros::Subscriber sub;
std::vector<uint8_t> kept;
void look(const sensor_msgs::ImageConstPtr& image) { (void)image; }
void start(ros::NodeHandle& nh) { sub = nh.subscribe("image", 1, look); }
}
//--- src/other.cpp
//------------------------------------------
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

namespace bb {
ros::Subscriber sub;
std::vector<uint8_t> kept;
void take(const sensor_msgs::ImageConstPtr& image) { kept.swap(const_cast<sensor_msgs::Image&>(*image).data); }
void start(ros::NodeHandle& nh) { sub = nh.subscribe("image", 1, take); }
}
//--- expected
// subscribe src/node.cpp:11 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it, by a callback of another subscription to its type, which may have the same topic
// subscribe src/other.cpp:11 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it

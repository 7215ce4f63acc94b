// One text subscribes for two instances, one of which could take the elements away.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

std::vector<uint8_t> kept;

template <class M>
struct In {
  In(ros::NodeHandle& nh, const std::string& topic, void (*callback)(const boost::shared_ptr<M const>&))
      : sub(nh.subscribe(topic, 1, callback)) {}
  ros::Subscriber sub;
};

void look(const sensor_msgs::ImageConstPtr&) {}
void steal(const sensor_msgs::PointCloud2ConstPtr& cloud) {
  kept.swap(const_cast<sensor_msgs::PointCloud2&>(*cloud).data);
}

int main() {
  ros::NodeHandle nh;
  In<sensor_msgs::Image> image(nh, "image", look);
  In<sensor_msgs::PointCloud2> cloud(nh, "cloud", steal);
}
//--- expected
// subscribe src/node.cpp:13 sensor_msgs/Image plain TZC2002 const is cast away from a message that may be this one
// subscribe src/node.cpp:13 sensor_msgs/PointCloud2 plain TZC2002 const is cast away from a message that may be this one

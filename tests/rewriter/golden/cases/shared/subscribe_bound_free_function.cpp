// A function that is bound, or a closure that becomes a pointer to its function, is known though the type of the result could hold another one.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Sum {
  unsigned long bytes = 0;
};

void add(const sensor_msgs::ImageConstPtr& image, Sum* sum) {
  sum->bytes += image->data.size();
}

void first(Sum& sum, const sensor_msgs::ImageConstPtr& image) {
  sum.bytes += image->data.size();
}

void run(ros::NodeHandle& nh, Sum& sum) {
  ros::Subscriber a = nh.subscribe<sensor_msgs::Image>("a", 1, boost::bind(add, _1, &sum));
  ros::Subscriber b = nh.subscribe<sensor_msgs::Image>("b", 1, boost::bind(&first, std::ref(sum), _1));
  ros::Subscriber c = nh.subscribe<sensor_msgs::Image>("c", 1, std::bind(add, std::placeholders::_1, &sum));
  ros::Subscriber d = nh.subscribe("d", 1, +[](const sensor_msgs::ImageConstPtr&) {});
}
//--- expected
// subscribe src/node.cpp:18 sensor_msgs/Image shared 'a'
// subscribe src/node.cpp:19 sensor_msgs/Image shared 'b'
// subscribe src/node.cpp:20 sensor_msgs/Image shared 'c'
// subscribe src/node.cpp:21 sensor_msgs/Image shared 'd'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Subscriber a = nh.subscribe<sensor_msgs::Image>("a", 1, boost::bind(add, _1, &sum));
// -  ros::Subscriber b = nh.subscribe<sensor_msgs::Image>("b", 1, boost::bind(&first, std::ref(sum), _1));
// -  ros::Subscriber c = nh.subscribe<sensor_msgs::Image>("c", 1, std::bind(add, std::placeholders::_1, &sum));
// -  ros::Subscriber d = nh.subscribe("d", 1, +[](const sensor_msgs::ImageConstPtr&) {});
// +  ros::Subscriber a = tzc::subscribe<sensor_msgs::Image>(nh, "a", 1, boost::bind(add, _1, &sum));
// +  ros::Subscriber b = tzc::subscribe<sensor_msgs::Image>(nh, "b", 1, boost::bind(&first, std::ref(sum), _1));
// +  ros::Subscriber c = tzc::subscribe<sensor_msgs::Image>(nh, "c", 1, std::bind(add, std::placeholders::_1, &sum));
// +  ros::Subscriber d = tzc::subscribe(nh, "d", 1, +[](const sensor_msgs::ImageConstPtr&) {});

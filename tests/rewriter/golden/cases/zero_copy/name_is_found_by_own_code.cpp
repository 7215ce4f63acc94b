// To find the publisher once more, code of the package would run once more: a comparison, a hash; or a volatile variable would be read.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <unordered_map>

static int uses = 0;
struct Less {
  bool operator()(int a, int b) const {
    ++uses;
    return a < b;
  }
};
struct Hash {
  size_t operator()(int number) const {
    ++uses;
    return number;
  }
};
static std::map<int, ros::Publisher, Less> by_order;
static std::unordered_map<int, ros::Publisher, Hash> by_hash;
static ros::Publisher by_index[2];
static volatile int which = 0;

void order() {
  sensor_msgs::Image image;
  image.data.resize(100);
  by_order.at(1).publish(image);
}
void hash() {
  sensor_msgs::Image image;
  image.data.resize(100);
  by_hash.at(1).publish(image);
}
void index() {
  sensor_msgs::Image image;
  image.data.resize(100);
  by_index[which].publish(image);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  by_order[1] = nh.advertise<sensor_msgs::Image>("a", 1);
  by_hash[1] = nh.advertise<sensor_msgs::Image>("b", 1);
  by_index[0] = nh.advertise<sensor_msgs::Image>("c", 1);
  order();
}
//--- expected
// publish src/node.cpp:29 sensor_msgs/Image zero_copy 'a'
// publish src/node.cpp:34 sensor_msgs/Image zero_copy 'b'
// publish src/node.cpp:39 sensor_msgs/Image zero_copy 'c'
// advertise src/node.cpp:45 sensor_msgs/Image zero_copy 'a'
// advertise src/node.cpp:46 sensor_msgs/Image zero_copy 'b'
// advertise src/node.cpp:47 sensor_msgs/Image zero_copy 'c'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -static std::map<int, ros::Publisher, Less> by_order;
// -static std::unordered_map<int, ros::Publisher, Hash> by_hash;
// -static ros::Publisher by_index[2];
// +static std::map<int, tzc::Publisher, Less> by_order;
// +static std::unordered_map<int, tzc::Publisher, Hash> by_hash;
// +static tzc::Publisher by_index[2];
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  by_order[1] = nh.advertise<sensor_msgs::Image>("a", 1);
// -  by_hash[1] = nh.advertise<sensor_msgs::Image>("b", 1);
// -  by_index[0] = nh.advertise<sensor_msgs::Image>("c", 1);
// +  by_order[1] = tzc::advertise<tzc::sensor_msgs::Image>(nh, "a", 1);
// +  by_hash[1] = tzc::advertise<tzc::sensor_msgs::Image>(nh, "b", 1);
// +  by_index[0] = tzc::advertise<tzc::sensor_msgs::Image>(nh, "c", 1);

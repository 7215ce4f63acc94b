// An object on the heap takes over the elements of a message that nobody allocated, to which a pointer leads: they stay where they lie.
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

void of_new(ros::NodeHandle& nh, int k) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("new", 1);
  std::optional<sensor_msgs::Image> built;
  built.emplace();
  built->data.resize(6000);
  uint8_t* first = &built->data[0];
  sensor_msgs::ImagePtr image(new sensor_msgs::Image(std::move(*built)));
  first[1] = k;
  pub.publish(image);
}

void of_make_shared(ros::NodeHandle& nh, int k) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("make_shared", 1);
  std::vector<sensor_msgs::Image> built(1);
  built[0].data.resize(6000);
  uint8_t* first = &built[0].data[0];
  auto image = boost::make_shared<sensor_msgs::Image>(std::move(built[0]));
  first[1] = k;
  pub.publish(image);
}

sensor_msgs::Image taken(std::optional<sensor_msgs::Image>& built) { return std::move(*built); }

void of_result(ros::NodeHandle& nh, int k) {
  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("result", 1);
  std::optional<sensor_msgs::Image> built;
  built.emplace();
  built->data.resize(6000);
  uint8_t* first = &built->data[0];
  std::unique_ptr<sensor_msgs::Image> image;
  image.reset(new sensor_msgs::Image(taken(built)));
  first[1] = k;
  pub.publish(*image);
}

int main() {
  ros::NodeHandle nh;
  for (int k = 0; k < 9; ++k) {
    of_new(nh, k);
    of_make_shared(nh, k);
    of_result(nh, k);
  }
}
//--- expected
// advertise src/node.cpp:11 sensor_msgs/Image one_copy 'new'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'new' TZC1019 it is an element of 'built', and nothing shows where that makes it
// advertise src/node.cpp:22 sensor_msgs/Image one_copy 'make_shared'
// publish src/node.cpp:28 sensor_msgs/Image one_copy 'make_shared' TZC1019 it is an element of 'built', and nothing shows where that makes it
// advertise src/node.cpp:34 sensor_msgs/Image one_copy 'result'
// publish src/node.cpp:42 sensor_msgs/Image one_copy 'result' TZC1019 it is an element of 'built', and nothing shows where that makes it
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("new", 1);
// +  static tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "new", 1);
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("make_shared", 1);
// +  static tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "make_shared", 1);
// -  static ros::Publisher pub = nh.advertise<sensor_msgs::Image>("result", 1);
// +  static tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "result", 1);

// The message is filled, or a pointer into it is kept, before its publisher is declared: allocate does not go behind that.
#include <cstring>
#include <map>
#include <string>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>
#include <sensor_msgs/point_cloud2_iterator.h>

std::map<std::string, ros::Publisher> pubs;

void fill(sensor_msgs::Image& image) { image.data.resize(6000); }

void by_function(const std::string& id) {
  sensor_msgs::Image image;
  fill(image);
  ros::Publisher& pub = pubs[id];
  pub.publish(image);
}

void by_pointer(const std::string& id, const void* pixels) {
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data.resize(6000);
  uint8_t* to = &image->data[0];
  ros::Publisher& pub = pubs[id];
  memcpy(to, pixels, 6000);
  pub.publish(image);
}

void by_iterator(const std::string& id) {
  sensor_msgs::PointCloud2 cloud;
  sensor_msgs::PointCloud2Modifier modifier(cloud);
  modifier.setPointCloud2FieldsByString(1, "xyz");
  modifier.resize(1000);
  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
  ros::Publisher& pub = pubs[id];
  *x = 1;
  pub.publish(cloud);
}

void in_a_block(const std::string& id) {
  sensor_msgs::Image image;
  image.height = 1;
  if (!id.empty()) {
    ros::Publisher& pub = pubs[id];
    fill(image);
    pub.publish(image);
  }
}

void plain_fields_only(const std::string& id) {
  sensor_msgs::Image image;
  image.height = 1;
  image.header.frame_id = id;
  ros::Publisher& pub = pubs[id];
  fill(image);
  pub.publish(image);
}

int main() {
  ros::NodeHandle nh;
  pubs["image"] = nh.advertise<sensor_msgs::Image>("image", 1);
  pubs["cloud"] = nh.advertise<sensor_msgs::PointCloud2>("cloud", 1);
  by_function("image");
  by_pointer("image", "");
  by_iterator("cloud");
  in_a_block("image");
  plain_fields_only("image");
}
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image zero_copy
// publish src/node.cpp:28 sensor_msgs/Image zero_copy
// publish src/node.cpp:39 sensor_msgs/PointCloud2 zero_copy
// publish src/node.cpp:48 sensor_msgs/Image zero_copy
// publish src/node.cpp:58 sensor_msgs/Image zero_copy
// advertise src/node.cpp:63 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:64 sensor_msgs/PointCloud2 zero_copy 'cloud'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs.h>
// -std::map<std::string, ros::Publisher> pubs;
// +std::map<std::string, tzc::Publisher> pubs;
// -void fill(sensor_msgs::Image& image) { image.data.resize(6000); }
// +void fill(tzc::sensor_msgs::Image& image) { image.data.resize(6000); }
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -  ros::Publisher& pub = pubs[id];
// +  tzc::Publisher& pub = pubs[id];
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  tzc::allocate(*image);
// -  ros::Publisher& pub = pubs[id];
// +  tzc::Publisher& pub = pubs[id];
// -  sensor_msgs::PointCloud2 cloud;
// -  sensor_msgs::PointCloud2Modifier modifier(cloud);
// +  tzc::sensor_msgs::PointCloud2 cloud;
// +  tzc::allocate(cloud);
// +  tzc::sensor_msgs::PointCloud2Modifier modifier(cloud);
// -  sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
// -  ros::Publisher& pub = pubs[id];
// +  tzc::sensor_msgs::PointCloud2Iterator<float> x(cloud, "x");
// +  tzc::Publisher& pub = pubs[id];
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  tzc::allocate(image);
// -    ros::Publisher& pub = pubs[id];
// +    tzc::Publisher& pub = pubs[id];
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// -  ros::Publisher& pub = pubs[id];
// +  tzc::Publisher& pub = pubs[id];
// +  pub.allocate(image);
// -  pubs["image"] = nh.advertise<sensor_msgs::Image>("image", 1);
// -  pubs["cloud"] = nh.advertise<sensor_msgs::PointCloud2>("cloud", 1);
// +  pubs["image"] = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);
// +  pubs["cloud"] = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "cloud", 1);

// A vector that is made from pointers and assigned: the array takes the elements itself.
#include <nav_msgs/OccupancyGrid.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Grid {
  signed char* datastart;
  signed char* dataend;
};

void publish(ros::Publisher& pub, const Grid& grid) {
  nav_msgs::OccupancyGrid map;
  map.data = std::vector<signed char>(grid.datastart, grid.dataend);
  pub.publish(map);
}

void publish(ros::Publisher& pub, const unsigned char* pixels, std::size_t size) {
  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
  image->data = std::vector<uint8_t>(pixels, pixels + size);
  pub.publish(image);
}

int main() {
  ros::NodeHandle nh;
  ros::Publisher maps = nh.advertise<nav_msgs::OccupancyGrid>("map", 1);
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
  publish(maps, Grid());
  publish(images, nullptr, 0);
}
//--- expected
// publish src/node.cpp:14 nav_msgs/OccupancyGrid zero_copy 'map'
// publish src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:25 nav_msgs/OccupancyGrid zero_copy 'map'
// advertise src/node.cpp:26 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/nav_msgs/OccupancyGrid.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -void publish(ros::Publisher& pub, const Grid& grid) {
// -  nav_msgs::OccupancyGrid map;
// -  map.data = std::vector<signed char>(grid.datastart, grid.dataend);
// +void publish(tzc::Publisher& pub, const Grid& grid) {
// +  tzc::nav_msgs::OccupancyGrid map;
// +  pub.allocate(map);
// +  map.data.assign(grid.datastart, grid.dataend);
// -void publish(ros::Publisher& pub, const unsigned char* pixels, std::size_t size) {
// -  sensor_msgs::ImagePtr image(new sensor_msgs::Image);
// -  image->data = std::vector<uint8_t>(pixels, pixels + size);
// +void publish(tzc::Publisher& pub, const unsigned char* pixels, std::size_t size) {
// +  tzc::sensor_msgs::ImagePtr image(new tzc::sensor_msgs::Image);
// +  pub.allocate(*image);
// +  image->data.assign(pixels, pixels + size);
// -  ros::Publisher maps = nh.advertise<nav_msgs::OccupancyGrid>("map", 1);
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher maps = tzc::advertise<tzc::nav_msgs::OccupancyGrid>(nh, "map", 1);
// +  tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);

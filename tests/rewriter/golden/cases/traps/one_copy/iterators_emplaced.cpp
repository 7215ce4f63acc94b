// Iterators that containers make of a member message point into what was published.
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/point_cloud2_iterator.h>

class Vector {
 public:
  explicit Vector(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("vector", 10)) {
    cloud_.data.resize(6000);
    for (const char* name : {"x", "y", "z"}) fields_.emplace_back(cloud_, name);
  }
  void tick() {
    *fields_[0] = 1;
    pub_.publish(cloud_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::vector<sensor_msgs::PointCloud2Iterator<float>> fields_;
};

class Optional {
 public:
  explicit Optional(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("optional", 10)) {
    cloud_.data.resize(6000);
    field_.emplace(cloud_, "x");
  }
  void tick() {
    **field_ = 1;
    pub_.publish(cloud_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::optional<sensor_msgs::PointCloud2Iterator<float>> field_;
};

class Map {
 public:
  explicit Map(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("map", 10)) {
    cloud_.data.resize(6000);
    fields_.emplace(std::piecewise_construct, std::forward_as_tuple("x"), std::forward_as_tuple(cloud_, "x"));
    fields_.try_emplace("y", cloud_, "y");
  }
  void tick() {
    *fields_.at("x") = 1;
    pub_.publish(cloud_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  std::map<std::string, sensor_msgs::PointCloud2Iterator<float>> fields_;
};

int main() {
  ros::NodeHandle nh;
  Vector(nh).tick();
  Optional(nh).tick();
  Map(nh).tick();
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/PointCloud2 one_copy 'vector'
// publish src/node.cpp:18 sensor_msgs/PointCloud2 one_copy 'vector' TZC1003 a pointer into its data is kept in a container
// advertise src/node.cpp:29 sensor_msgs/PointCloud2 one_copy 'optional'
// publish src/node.cpp:35 sensor_msgs/PointCloud2 one_copy 'optional' TZC1003 a pointer into its data is kept in a container
// advertise src/node.cpp:46 sensor_msgs/PointCloud2 one_copy 'map'
// publish src/node.cpp:53 sensor_msgs/PointCloud2 one_copy 'map' TZC1003 a pointer into its data is kept in a container
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Vector(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("vector", 10)) {
// +  explicit Vector(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::PointCloud2>(nh, "vector", 10)) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Optional(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("optional", 10)) {
// +  explicit Optional(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::PointCloud2>(nh, "optional", 10)) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Map(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("map", 10)) {
// +  explicit Map(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::PointCloud2>(nh, "map", 10)) {
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;

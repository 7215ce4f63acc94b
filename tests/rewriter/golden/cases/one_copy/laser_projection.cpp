// The library projects into a PointCloud by itself, and reads the stock scan that is published behind it.
#include <laser_geometry/laser_geometry.h>
#include <ros/ros.h>

class Node {
 public:
  Node() {
    pub_ = nh_.advertise<sensor_msgs::PointCloud>("points", 10);
    scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
    clouds_ = nh_.advertise<sensor_msgs::PointCloud2>("points2", 10);
  }
  void tick(unsigned beams) {
    sensor_msgs::LaserScan scan;
    scan.ranges.resize(beams);
    sensor_msgs::PointCloud cloud;
    projector_.projectLaser(scan, cloud);
    pub_.publish(cloud);
    sensor_msgs::PointCloud2 cloud2;
    projector_.projectLaser(scan, cloud2);
    clouds_.publish(cloud2);
    scans_.publish(scan);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_, scans_, clouds_;
  laser_geometry::LaserProjection projector_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/PointCloud one_copy 'points'
// advertise src/node.cpp:9 sensor_msgs/LaserScan one_copy 'scan'
// advertise src/node.cpp:10 sensor_msgs/PointCloud2 zero_copy 'points2'
// publish src/node.cpp:17 sensor_msgs/PointCloud one_copy 'points' TZC1002 it is passed to 'laser_geometry::LaserProjection::projectLaser', which is not part of the package
// publish src/node.cpp:20 sensor_msgs/PointCloud2 zero_copy 'points2'
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy 'scan' TZC1002 it is passed to 'laser_geometry::LaserProjection::projectLaser', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/laser_geometry.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud>("points", 10);
// -    scans_ = nh_.advertise<sensor_msgs::LaserScan>("scan", 10);
// -    clouds_ = nh_.advertise<sensor_msgs::PointCloud2>("points2", 10);
// +    pub_ = tzc::advertise<sensor_msgs::PointCloud>(nh_, "points", 10);
// +    scans_ = tzc::advertise<sensor_msgs::LaserScan>(nh_, "scan", 10);
// +    clouds_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points2", 10);
// -    sensor_msgs::PointCloud2 cloud2;
// -    projector_.projectLaser(scan, cloud2);
// +    tzc::sensor_msgs::PointCloud2 cloud2;
// +    clouds_.allocate(cloud2);
// +    tzc::laser_geometry::projectLaser(projector_, scan, cloud2);
// -  ros::Publisher pub_, scans_, clouds_;
// +  tzc::Publisher pub_, scans_, clouds_;

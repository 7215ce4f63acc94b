// A scan is projected into the published cloud, by an object and through pointers.
#include <laser_geometry/laser_geometry.h>
#include <ros/ros.h>

class Node {
 public:
  Node() : other_(new laser_geometry::LaserProjection) {
    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 10);
    far_ = nh_.advertise<sensor_msgs::PointCloud2>("far_points", 10);
    sub_ = nh_.subscribe("scan", 10, &Node::project, this);
  }

 private:
  void project(const sensor_msgs::LaserScan::ConstPtr& scan) {
    sensor_msgs::PointCloud2 cloud;
    projector_.projectLaser(*scan, cloud);
    pub_.publish(cloud);
    sensor_msgs::PointCloud2Ptr far(new sensor_msgs::PointCloud2);
    other_->projectLaser(*scan, *far, 30.0, laser_geometry::channel_option::Distance);
    far_.publish(far);
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_, far_;
  ros::Subscriber sub_;
  laser_geometry::LaserProjection projector_;
  boost::shared_ptr<laser_geometry::LaserProjection> other_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/PointCloud2 zero_copy 'points'
// advertise src/node.cpp:9 sensor_msgs/PointCloud2 zero_copy 'far_points'
// subscribe src/node.cpp:10 sensor_msgs/LaserScan shared 'scan'
// publish src/node.cpp:17 sensor_msgs/PointCloud2 zero_copy 'points'
// publish src/node.cpp:20 sensor_msgs/PointCloud2 zero_copy 'far_points'
//
// +++ src/node.cpp
// +#include <tzc/laser_geometry.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 10);
// -    far_ = nh_.advertise<sensor_msgs::PointCloud2>("far_points", 10);
// -    sub_ = nh_.subscribe("scan", 10, &Node::project, this);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points", 10);
// +    far_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "far_points", 10);
// +    sub_ = tzc::subscribe(nh_, "scan", 10, &Node::project, this);
// -    sensor_msgs::PointCloud2 cloud;
// -    projector_.projectLaser(*scan, cloud);
// +    tzc::sensor_msgs::PointCloud2 cloud;
// +    pub_.allocate(cloud);
// +    tzc::laser_geometry::projectLaser(projector_, *scan, cloud);
// -    sensor_msgs::PointCloud2Ptr far(new sensor_msgs::PointCloud2);
// -    other_->projectLaser(*scan, *far, 30.0, laser_geometry::channel_option::Distance);
// +    tzc::sensor_msgs::PointCloud2Ptr far(new tzc::sensor_msgs::PointCloud2);
// +    far_.allocate(*far);
// +    tzc::laser_geometry::projectLaser(*other_, *scan, *far, 30.0, laser_geometry::channel_option::Distance);
// -  ros::Publisher pub_, far_;
// +  tzc::Publisher pub_, far_;

// Objects of a library that publish what they are given, with publishers that nobody shows. What is light is not named.
#include <diagnostic_updater/publisher.h>
#include <other/library.h>
#include <sensor_msgs/LaserScan.h>

#define ADVERTISED(name, nh) name(nh.advertise<sensor_msgs::LaserScan>(#name, 1))

class Node {
 public:
  explicit Node(ros::NodeHandle& nh)
      : first_(nh.advertise<sensor_msgs::LaserScan>("first", 1)), ADVERTISED(second_, nh) {}
  void tick(const sensor_msgs::Image& image, const sensor_msgs::PointCloud2ConstPtr& cloud) {
    recorder_.publish(image, 1.0);
    recorder_.publishCloud(cloud);
    recorder_.publish(1);
    first_.publish(sensor_msgs::LaserScan());
  }

 private:
  other::Recorder recorder_;
  diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan> first_, second_;
};
//--- expected
// advertise src/node.cpp:11 sensor_msgs/LaserScan one_copy 'first' TZC1010 it is passed to 'diagnostic_updater::DiagnosedPublisher', which is not part of the package
// advertise src/node.cpp:11 sensor_msgs/LaserScan plain 'second_' TZC1006 the advertise call comes from a macro
// publish src/node.cpp:13 sensor_msgs/Image plain TZC1021 'other::Recorder' publishes it
// publish src/node.cpp:14 sensor_msgs/PointCloud2 plain TZC1021 'other::Recorder' publishes it
// publish src/node.cpp:16 sensor_msgs/LaserScan plain TZC1021 'diagnostic_updater::DiagnosedPublisher' publishes it
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -      : first_(nh.advertise<sensor_msgs::LaserScan>("first", 1)), ADVERTISED(second_, nh) {}
// +      : first_(tzc::attached<sensor_msgs::LaserScan>(nh.advertise<sensor_msgs::LaserScan>("first", 1))), ADVERTISED(second_, nh) {}

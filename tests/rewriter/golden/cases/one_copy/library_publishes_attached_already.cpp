// What an earlier run attached stays so.
#include <diagnostic_updater/publisher.h>
#include <sensor_msgs/LaserScan.h>
#include <tzc/ros.h>

class Laser {
 public:
  explicit Laser(ros::NodeHandle& nh)
      : diagnosed_(tzc::attached<sensor_msgs::LaserScan>(nh.advertise<sensor_msgs::LaserScan>("scan", 10))) {}
  void tick(const sensor_msgs::LaserScan& scan) { diagnosed_.publish(scan); }

 private:
  diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan> diagnosed_;
};
//--- expected
// advertise src/node.cpp:9 sensor_msgs/LaserScan one_copy 'scan' TZC1010 it is passed to 'diagnostic_updater::DiagnosedPublisher', which is not part of the package
// publish src/node.cpp:10 sensor_msgs/LaserScan one_copy TZC1021 'diagnostic_updater::DiagnosedPublisher' publishes it

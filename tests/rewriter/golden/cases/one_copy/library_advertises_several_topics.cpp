// A publisher of laser_proc advertises and publishes on several topics by itself.
#include <laser_proc/LaserTransport.h>

class Scanner {
 public:
  explicit Scanner(ros::NodeHandle& nh) { pub_ = laser_proc::LaserTransport::advertiseLaser(nh, 20); }
  void tick() {
    sensor_msgs::MultiEchoLaserScanPtr scan(new sensor_msgs::MultiEchoLaserScan);
    scan->ranges.resize(1080);
    pub_.publish(scan);
  }

 private:
  laser_proc::LaserPublisher pub_;
};
//--- expected
// advertise src/node.cpp:6 sensor_msgs/MultiEchoLaserScan one_copy TZC1021 'laser_proc::LaserPublisher' advertises its topics
// publish src/node.cpp:10 sensor_msgs/MultiEchoLaserScan one_copy TZC1021 'laser_proc::LaserPublisher' publishes it
//
// +++ src/node.cpp
// +#include <tzc/laser_proc.h>
// -  explicit Scanner(ros::NodeHandle& nh) { pub_ = laser_proc::LaserTransport::advertiseLaser(nh, 20); }
// +  explicit Scanner(ros::NodeHandle& nh) { pub_ = tzc::laser_proc::attached(laser_proc::LaserTransport::advertiseLaser(nh, 20)); }

// An earlier run attached them.
#include <laser_proc/LaserTransport.h>
#include <tzc/laser_proc.h>

void run(ros::NodeHandle& nh, const sensor_msgs::MultiEchoLaserScan& scan) {
  laser_proc::LaserPublisher pub = tzc::laser_proc::attached(laser_proc::LaserTransport::advertiseLaser(nh, 20));
  pub.publish(scan);
}
//--- expected
// advertise src/node.cpp:6 sensor_msgs/MultiEchoLaserScan one_copy TZC1021 'laser_proc::LaserPublisher' advertises its topics
// publish src/node.cpp:7 sensor_msgs/MultiEchoLaserScan one_copy TZC1021 'laser_proc::LaserPublisher' publishes it

// One of its publishers is advertised by a macro, so the scans of one node stay on TCPROS.
#include <laser_proc/LaserTransport.h>

#define ADVERTISED(nh) laser_proc::LaserPublisher second = laser_proc::LaserTransport::advertiseLaser(nh, 1)

void run(ros::NodeHandle& nh, const sensor_msgs::MultiEchoLaserScan& scan) {
  laser_proc::LaserPublisher first = laser_proc::LaserTransport::advertiseLaser(nh, 20);
  ADVERTISED(nh);
  first.publish(scan);
  second.publish(scan);
}
//--- expected
// advertise src/node.cpp:7 sensor_msgs/MultiEchoLaserScan one_copy TZC1021 'laser_proc::LaserPublisher' advertises its topics
// advertise src/node.cpp:8 sensor_msgs/MultiEchoLaserScan plain TZC1021 'laser_proc::LaserPublisher' advertises its topics
// publish src/node.cpp:9 sensor_msgs/MultiEchoLaserScan plain TZC1021 'laser_proc::LaserPublisher' publishes it
// publish src/node.cpp:10 sensor_msgs/MultiEchoLaserScan plain TZC1021 'laser_proc::LaserPublisher' publishes it
//
// +++ src/node.cpp
// +#include <tzc/laser_proc.h>
// -  laser_proc::LaserPublisher first = laser_proc::LaserTransport::advertiseLaser(nh, 20);
// +  laser_proc::LaserPublisher first = tzc::laser_proc::attached(laser_proc::LaserTransport::advertiseLaser(nh, 20));

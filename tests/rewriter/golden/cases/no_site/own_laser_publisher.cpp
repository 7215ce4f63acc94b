// The package that has laser_proc's class: its own calls are no calls of a library.
#include <laser/laser.h>

namespace laser_proc {
LaserPublisher LaserTransport::advertiseLaser(ros::NodeHandle& nh, uint32_t queue_size) {
  return advertiseLaser(nh, queue_size, false);
}
LaserPublisher LaserTransport::advertiseLaser(ros::NodeHandle&, uint32_t, bool) {
  return LaserPublisher();
}
}  // namespace laser_proc
//--- include/laser/laser.h
#include <ros/ros.h>
namespace laser_proc {
class LaserPublisher {};
class LaserTransport {
 public:
  static LaserPublisher advertiseLaser(ros::NodeHandle& nh, uint32_t queue_size);
  static LaserPublisher advertiseLaser(ros::NodeHandle& nh, uint32_t queue_size, bool latch);
};
}  // namespace laser_proc
//--- expected

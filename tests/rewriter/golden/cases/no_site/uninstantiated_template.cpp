// A template that nothing instantiates is left alone.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class M>
void send(const ros::Publisher& pub, const M& message) {
  pub.publish(message);
}
//--- expected

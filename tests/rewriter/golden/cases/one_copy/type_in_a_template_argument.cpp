// The call says the type of the message that the function template makes, so that is a stock one, for which allocate does nothing.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

ros::Publisher pub;

template <class M>
void make(int size) {
  M out;
  out.data.resize(size);
  pub.publish(out);
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("out", 1);
  make<sensor_msgs::Image>(100);
}
//--- expected

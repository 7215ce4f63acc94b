// Templates that only call a publisher's functions, and a declaration by decltype, do not ask for its type.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class P>
bool is_wanted(const P& publisher) {
  return publisher.getNumSubscribers() > 0;
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("wanted", 1);
  decltype(pub)& same = pub;
  sensor_msgs::Image image;
  image.data.resize(100);
  if (is_wanted(same)) same.publish(image);
}
//--- expected

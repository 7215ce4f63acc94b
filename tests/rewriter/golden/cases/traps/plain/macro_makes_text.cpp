// A macro makes a text of the type that it writes: that is published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define FIELD(type, name) \
  type name;              \
  static const char* type_of_##name() { return #type; }
#define LOGGED(call)        \
  do {                      \
    ROS_INFO("%s", #call);  \
    call;                   \
  } while (false)

class Node {
 public:
  Node() {
    LOGGED(pub_ = nh_.advertise<sensor_msgs::Image>("image", 1));
    image_.encoding = type_of_image_();
  }
  void tick(int n) {
    image_.data.assign(n, 7);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  FIELD(sensor_msgs::Image, image_)
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/Image plain 'image' TZC1006 a macro makes a text of the code that would be changed
// publish src/node.cpp:22 sensor_msgs/Image plain 'image' TZC1006 a macro makes a text of the code that would be changed

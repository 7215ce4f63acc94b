// A constant copy cannot be assigned later, and need not be: it shares the elements of the message that was just published.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void tick(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    if (count % 100 == 0) {
      const sensor_msgs::Image again = image;
      again_pub_.publish(again);
    }
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher again_pub_ = nh_.advertise<sensor_msgs::Image>("again", 1);
};
//--- expected

// A copy of a member that is assigned to a message which was made empty: it goes into shared memory.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void take(const std::vector<uint8_t>& pixels) {
    last_.data.clear();
    last_.data.insert(last_.data.end(), pixels.begin(), pixels.end());
  }
  void tick() {
    sensor_msgs::Image out;
    out = last_;
    out.header.frame_id = "camera";
    pub_.publish(out);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image last_;
};

int main() {
  Node node;
  node.take({});
  node.tick();
}
//--- expected
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:20 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image out;
// +    tzc::sensor_msgs::Image out;
// +    pub_.allocate(out);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);

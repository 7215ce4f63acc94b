// The destructor of a temporary without a constructor writes after the publish.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  void publish() {
    sensor_msgs::Image image;
    image.data.resize(100);
    first_ = &image.data[0];
    pub_.publish(image);
    Mark{this};
  }
  struct Mark {
    Node* node;
    ~Mark() { *node->first_ = 1; }
  };

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  uint8_t* first_ = nullptr;
};
//--- expected
// advertise src/node.cpp:7 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'first_'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;

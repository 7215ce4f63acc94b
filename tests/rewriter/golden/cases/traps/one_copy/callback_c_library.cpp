// A function of the C library that the compiler knows is given one of the package.
#include <pthread.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
  static void* work(void* self) {
    static_cast<Node*>(self)->send();
    return nullptr;
  }
  void send() {
    pub_.publish(image_);
    sent_ = true;
  }
  void draw() {
    uint8_t* first = &image_.data[0];
    pthread_t thread;
    pthread_create(&thread, nullptr, &Node::work, this);
    while (!sent_) {
    }
    *first = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::Image image_;
  volatile bool sent_ = false;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'image' TZC1003 'first' points into its data and is used after the message may have been published
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  Node() { pub_ = nh_.advertise<sensor_msgs::Image>("image", 10); }
// +  Node() { pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "image", 10); }
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;

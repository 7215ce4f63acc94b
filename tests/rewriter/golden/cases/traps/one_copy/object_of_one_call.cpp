// An object that lives as long as a call: its message is new at each publish, though it is a member. The same class as a
// member itself, whose message lasts, is another matter; so is one that main makes for all its turns.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Renderer {
 public:
  explicit Renderer(ros::Publisher& pub) : pub_(pub) {}
  void render(int n) {
    image_.data.assign(n, 1);
    pub_.publish(image_);
  }

 private:
  ros::Publisher& pub_;
  sensor_msgs::Image image_;
};

class Lasting {
 public:
  explicit Lasting(ros::Publisher& pub) : pub_(pub) {}
  void render(int n) {
    image_.data.assign(n, 1);
    pub_.publish(image_);
  }

 private:
  ros::Publisher& pub_;
  sensor_msgs::Image image_;
};

class Node {
 public:
  void tick(const ros::TimerEvent&) {
    Renderer renderer(pub_);
    renderer.render(1000);
    lasting_.render(2000);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  Lasting lasting_{pub_};
};

class Loop {
 public:
  void turn() {
    image_.data.assign(1000, 1);
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("loop", 1);
  sensor_msgs::Image image_;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node;
  Loop loop;
  while (ros::ok()) loop.turn();
}
//--- expected
// publish src/node.cpp:11 sensor_msgs/Image one_copy 'image' TZC1022 its object is new here each time, and its elements lie outside shared memory until it is published
// publish src/node.cpp:24 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:42 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:50 sensor_msgs/Image zero_copy 'loop'
// advertise src/node.cpp:55 sensor_msgs/Image zero_copy 'loop'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Renderer(ros::Publisher& pub) : pub_(pub) {}
// +  explicit Renderer(tzc::Publisher& pub) : pub_(pub) {}
// -  ros::Publisher& pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher& pub_;
// +  tzc::sensor_msgs::Image image_;
// -  explicit Lasting(ros::Publisher& pub) : pub_(pub) {}
// +  explicit Lasting(tzc::Publisher& pub) : pub_(pub) {}
// -  ros::Publisher& pub_;
// -  sensor_msgs::Image image_;
// +  tzc::Publisher& pub_;
// +  tzc::sensor_msgs::Image image_;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("loop", 1);
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "loop", 1);
// +  tzc::sensor_msgs::Image image_;

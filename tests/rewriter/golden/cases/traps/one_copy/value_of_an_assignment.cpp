// The value of an assignment, of a step and of a statement expression is another name of the message, whose type nobody wrote.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Kept {
  unsigned char* elements;
};

class Made {
 public:
  void send(Kept& kept) {
    sensor_msgs::Image* image;
    auto& same = *(image = new sensor_msgs::Image);
    image->data.resize(100);
    kept.elements = same.data.data();
    pub_.publish(*image);
    kept.elements[0] = 1;
    delete image;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("made", 1);
};

class Named {
 public:
  void send(Kept& kept) {
    sensor_msgs::Image image;
    sensor_msgs::Image* at;
    auto* same = (at = &image);
    image.data.resize(100);
    kept.elements = same->data.data();
    pub_.publish(image);
    kept.elements[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("named", 1);
};

class Stepped {
 public:
  void send(Kept& kept) {
    sensor_msgs::Image images[2];
    sensor_msgs::Image* at = images;
    auto* same = (at += 1);
    images[1].data.resize(100);
    kept.elements = same->data.data();
    pub_.publish(images[1]);
    kept.elements[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("stepped", 1);
};

class Statements {
 public:
  void send(Kept& kept) {
    sensor_msgs::Image image;
    auto* same = ({ auto* at = &image; at; });
    image.data.resize(100);
    kept.elements = same->data.data();
    pub_.publish(image);
    kept.elements[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("statements", 1);
};
//--- expected
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'made' TZC1003 a pointer into its data is kept in 'kept.elements'
// advertise src/node.cpp:23 sensor_msgs/Image one_copy 'made'
// publish src/node.cpp:34 sensor_msgs/Image one_copy 'named' TZC1003 a pointer into its data is kept in 'kept.elements'
// advertise src/node.cpp:40 sensor_msgs/Image one_copy 'named'
// publish src/node.cpp:51 sensor_msgs/Image one_copy 'stepped' TZC1003 a pointer into its data is kept in 'kept.elements'
// advertise src/node.cpp:57 sensor_msgs/Image one_copy 'stepped'
// publish src/node.cpp:67 sensor_msgs/Image one_copy 'statements' TZC1001 it is the value of a statement expression
// advertise src/node.cpp:73 sensor_msgs/Image one_copy 'statements'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("made", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "made", 1);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("named", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "named", 1);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("stepped", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "stepped", 1);
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("statements", 1);
// +  tzc::Publisher pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "statements", 1);

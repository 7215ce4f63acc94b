// An object that is made from a message that was not published yet holds a copy, with elements of its own.
#include <memory>
#include <optional>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class MadeToBePublished {
 public:
  explicit MadeToBePublished(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("made", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pub_.publish(boost::make_shared<sensor_msgs::Image>(image));
  }

 private:
  ros::Publisher pub_;
};

class MadeBefore {
 public:
  explicit MadeBefore(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("before", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    sensor_msgs::ImagePtr copy(new sensor_msgs::Image(image));
    pub_.publish(copy);
  }

 private:
  ros::Publisher pub_;
};

class MadeOptional {
 public:
  explicit MadeOptional(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("optional", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    const auto copy = std::make_optional<sensor_msgs::Image>(image);
    pub_.publish(*copy);
  }

 private:
  ros::Publisher pub_;
};

class Plain {
 public:
  explicit Plain(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("plain", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    const sensor_msgs::Image copy = image;
    pub_.publish(copy);
  }

 private:
  ros::Publisher pub_;
};

int main() {
  ros::NodeHandle nh;
  MadeToBePublished(nh).tick();
  MadeBefore(nh).tick();
  MadeOptional(nh).tick();
  Plain(nh).tick();
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'made'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'made' TZC1020 it starts as a copy of another message
// advertise src/node.cpp:23 sensor_msgs/Image zero_copy 'before'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'before'
// advertise src/node.cpp:37 sensor_msgs/Image one_copy 'optional'
// publish src/node.cpp:42 sensor_msgs/Image one_copy 'optional' TZC1013 it starts as 'std::make_optional<sensor_msgs::Image>(image)', which code outside the package builds
// advertise src/node.cpp:51 sensor_msgs/Image one_copy 'plain'
// publish src/node.cpp:56 sensor_msgs/Image one_copy 'plain' TZC1020 it starts as a copy of another message
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit MadeToBePublished(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("made", 1)) {}
// +  explicit MadeToBePublished(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "made", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit MadeBefore(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("before", 1)) {}
// +  explicit MadeBefore(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "before", 1)) {}
// -    sensor_msgs::ImagePtr copy(new sensor_msgs::Image(image));
// +    tzc::sensor_msgs::ImagePtr copy(new tzc::sensor_msgs::Image());
// +    pub_.allocate(*copy);
// +    *copy = image;
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit MadeOptional(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("optional", 1)) {}
// +  explicit MadeOptional(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "optional", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Plain(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("plain", 1)) {}
// +  explicit Plain(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "plain", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;

// An object of any type keeps what it is given as what it is: std::any takes a vector, boost::any, and containers of them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <any>
#include <vector>

class Last {
 public:
  explicit Last(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("assigned", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(40000);
    last_ = image.data;
    pub_.publish(image);
  }
  bool is_kept() const { return std::any_cast<std::vector<uint8_t>>(&last_) != nullptr; }

 private:
  ros::Publisher pub_;
  std::any last_;
};

class Board {
 public:
  explicit Board(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("emplaced", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(40000);
    entries_.emplace_back(image.data);
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
  std::vector<std::any> entries_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'assigned'
// publish src/node.cpp:15 sensor_msgs/Image one_copy 'assigned' TZC1003 a pointer into its data goes to 'std::any::operator=', which asks for its type
// advertise src/node.cpp:26 sensor_msgs/Image one_copy 'emplaced'
// publish src/node.cpp:31 sensor_msgs/Image one_copy 'emplaced' TZC1003 a pointer into its data goes to 'std::vector::emplace_back', which asks for its type
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Last(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("assigned", 1)) {}
// +  explicit Last(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "assigned", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Board(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("emplaced", 1)) {}
// +  explicit Board(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "emplaced", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;

// Messages are kept in objects whose type does not tell, or asked whether somebody still holds them.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <any>
#include <memory>

class Kept {
 public:
  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(40000);
    pub_.publish(image);
    last_ = image;
  }

 private:
  ros::Publisher pub_;
  std::any last_;
};

class Untyped {
 public:
  explicit Untyped(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("untyped", 1)) {}
  void tick() {
    boost::shared_ptr<sensor_msgs::Image> image(new sensor_msgs::Image);
    image->data.resize(40000);
    last_ = image;
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
  boost::shared_ptr<void> last_;
};
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'kept'
// publish src/node.cpp:14 sensor_msgs/Image one_copy 'kept' TZC1001 it becomes part of 'last_', whose type does not tell
// advertise src/node.cpp:25 sensor_msgs/Image one_copy 'untyped'
// publish src/node.cpp:30 sensor_msgs/Image one_copy 'untyped' TZC1002 it is passed to 'boost::shared_ptr', which is not part of the package
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {}
// +  explicit Kept(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "kept", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  explicit Untyped(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("untyped", 1)) {}
// +  explicit Untyped(ros::NodeHandle& nh) : pub_(tzc::advertise<sensor_msgs::Image>(nh, "untyped", 1)) {}
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;

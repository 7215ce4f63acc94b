// A deleter that keeps the message, counts, casts, or captures what has a destructor shows when nobody holds the message any more.
#include <memory>
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

std::vector<sensor_msgs::Image*> pool;

void keep(sensor_msgs::Image* image) {
  pool.push_back(image);
}

class Node {
 public:
  void by_pool() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image, keep);
    image->data.resize(6000);
    pool_pub_.publish(image);
  }
  void by_count() {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image, [this](sensor_msgs::Image* m) {
      ++ended_;
      delete m;
    });
    image->data.resize(6000);
    count_pub_.publish(image);
  }
  void by_capture(std::shared_ptr<int> loan) {
    sensor_msgs::ImagePtr image(new sensor_msgs::Image, [loan](sensor_msgs::Image* m) { delete m; });
    image->data.resize(6000);
    loan_pub_.publish(image);
  }

 private:
  ros::NodeHandle nh_;
  int ended_ = 0;
  ros::Publisher pool_pub_ = nh_.advertise<sensor_msgs::Image>("pool", 1);
  ros::Publisher count_pub_ = nh_.advertise<sensor_msgs::Image>("count", 1);
  ros::Publisher loan_pub_ = nh_.advertise<sensor_msgs::Image>("loan", 1);
};
//--- expected
// publish src/node.cpp:19 sensor_msgs/Image one_copy 'pool' TZC1001 its deleter does more than delete it, or is not seen
// publish src/node.cpp:27 sensor_msgs/Image one_copy 'count' TZC1001 its deleter does more than delete it, or is not seen
// publish src/node.cpp:32 sensor_msgs/Image one_copy 'loan' TZC1001 its deleter does more than delete it, or is not seen
// advertise src/node.cpp:38 sensor_msgs/Image one_copy 'pool'
// advertise src/node.cpp:39 sensor_msgs/Image one_copy 'count'
// advertise src/node.cpp:40 sensor_msgs/Image one_copy 'loan'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pool_pub_ = nh_.advertise<sensor_msgs::Image>("pool", 1);
// -  ros::Publisher count_pub_ = nh_.advertise<sensor_msgs::Image>("count", 1);
// -  ros::Publisher loan_pub_ = nh_.advertise<sensor_msgs::Image>("loan", 1);
// +  tzc::Publisher pool_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "pool", 1);
// +  tzc::Publisher count_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "count", 1);
// +  tzc::Publisher loan_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "loan", 1);

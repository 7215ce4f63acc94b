// The message was not published on each way to the copy, or has been written to since: the copy has elements of its own.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Node {
 public:
  void perhaps(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    if (count > 7) pub_.publish(image);
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  void written(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    image.data[0] = 2;
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  void by_another_name(int count) {
    sensor_msgs::Image image;
    sensor_msgs::Image& name = image;
    image.data.assign(count, 1);
    pub_.publish(image);
    name.data[0] = 2;
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  void in_a_loop(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    pub_.publish(image);
    for (int i = 0; i < 3; ++i) {
      const sensor_msgs::Image again = image;
      copy_pub_.publish(again);
      image.data[i] = 3;
    }
  }
  void jumped_over(int count) {
    sensor_msgs::Image image;
    image.data.assign(count, 1);
    if (count > 7) goto copy;
    pub_.publish(image);
  copy : {
    const sensor_msgs::Image again = image;
    copy_pub_.publish(again);
  }
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
};
//--- expected
// publish src/node.cpp:10 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:12 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 11), whose elements lie outside shared memory until it is published
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1022 line 18 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 19), whose elements lie outside shared memory until it is published
// publish src/node.cpp:26 sensor_msgs/Image one_copy 'image' TZC1022 line 27 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 28), whose elements lie outside shared memory until it is published
// publish src/node.cpp:34 sensor_msgs/Image one_copy 'image' TZC1022 line 38 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:37 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 36), whose elements lie outside shared memory until it is published
// publish src/node.cpp:45 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:48 sensor_msgs/Image one_copy 'copy' TZC1022 it is a copy (made in line 47), whose elements lie outside shared memory until it is published
// advertise src/node.cpp:54 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:55 sensor_msgs/Image one_copy 'copy'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    const sensor_msgs::Image again = image;
// +    const tzc::sensor_msgs::Image again = image;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    const sensor_msgs::Image again = image;
// +    const tzc::sensor_msgs::Image again = image;
// -    sensor_msgs::Image image;
// -    sensor_msgs::Image& name = image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// +    tzc::sensor_msgs::Image& name = image;
// -    const sensor_msgs::Image again = image;
// +    const tzc::sensor_msgs::Image again = image;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -      const sensor_msgs::Image again = image;
// +      const tzc::sensor_msgs::Image again = image;
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    const sensor_msgs::Image again = image;
// +    const tzc::sensor_msgs::Image again = image;
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  ros::Publisher copy_pub_ = nh_.advertise<sensor_msgs::Image>("copy", 1);
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::Publisher copy_pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "copy", 1);

// A macro that writes the size or names the array means another thing where the array is written; one hides that it is read.
#include <cstring>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#define RESIZE(image, size) image.data.resize(size)

void run(ros::NodeHandle& nh, const uint8_t* pixels) {
  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
  sensor_msgs::Image first, second, third, fourth, fifth, sixth, other;
#define SIZE 100
  first.data.resize(SIZE);
#undef SIZE
#define SIZE 50
  memcpy(&first.data[0], pixels, SIZE);
  images.publish(first);
#define HALF 100
  second.data.resize(2 * HALF);
#undef HALF
#define HALF 50
  for (int i = 0; i < 2 * HALF; ++i) second.data[i] = 1;
  images.publish(second);
  RESIZE(third, SIZE);
  memcpy(&third.data[0], pixels, SIZE);
  images.publish(third);
  const int large = ros::ok() ? 100 : 200, small = 50;
#define NUMBER large
  fourth.data.resize(1 * NUMBER);
#undef NUMBER
#define NUMBER small
  for (int i = 0; i < 1 * NUMBER; ++i) fourth.data[i] = 1;
  images.publish(fourth);
#define NAME fifth
  NAME.data.resize(100);
#undef NAME
#define NAME other
  memcpy(&NAME.data[0], pixels, 100);
  images.publish(fifth);
#define PART sixth.data[50]
  sixth.data.resize(100);
  memcpy(&sixth.data[0], &PART, 100);
  images.publish(sixth);
}
//--- expected
// advertise src/node.cpp:9 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:22 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:32 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:38 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:42 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher images = nh.advertise<sensor_msgs::Image>("image", 10);
// -  sensor_msgs::Image first, second, third, fourth, fifth, sixth, other;
// +  tzc::Publisher images = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 10);
// +  tzc::sensor_msgs::Image first, second, third, fourth, fifth, sixth;
// +  sensor_msgs::Image other;
// +  images.allocate(first);
// +  images.allocate(second);
// +  images.allocate(third);
// +  images.allocate(fourth);
// +  images.allocate(fifth);
// +  images.allocate(sixth);

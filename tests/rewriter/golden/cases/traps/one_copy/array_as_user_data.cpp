// What is called back with the array's address makes it a std::vector again.
#include <pthread.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

static void append(void* user, const uint8_t* bytes, size_t n) {
  std::vector<uint8_t>* out = static_cast<std::vector<uint8_t>*>(user);
  out->insert(out->end(), bytes, bytes + n);
}

void run(ros::NodeHandle& nh, pthread_key_t key) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  const uint8_t part[] = {1, 2, 3};
  sensor_msgs::Image called;
  append(&called.data, part, 3);
  pub.publish(called);
  sensor_msgs::Image kept;
  pthread_setspecific(key, &kept.data);
  append(pthread_getspecific(key), part, 3);
  pub.publish(kept);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image'
// publish src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes a 'void *', which does not tell that an array lies there
// publish src/node.cpp:20 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes a 'const void *', which does not tell that an array lies there
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);

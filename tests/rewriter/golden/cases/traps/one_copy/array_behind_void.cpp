// The array's address in a local variable whose type does not tell, and in parts of other objects.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <map>
#include <utility>
#include <vector>

static void grow(std::pair<void*, size_t> where) {
  static_cast<std::vector<uint8_t>*>(where.first)->resize(where.second, 3);
}

void in_a_variable(ros::Publisher& pub) {
  sensor_msgs::Image image;
  void* raw = &image.data;
  ((std::vector<uint8_t>*)raw)->assign(100, 'x');
  pub.publish(image);
}

void in_a_container(ros::Publisher& pub) {
  sensor_msgs::Image image;
  std::vector<void*> users;
  users.push_back(&image.data);
  static_cast<std::vector<uint8_t>*>(users[0])->assign(100, 7);
  pub.publish(image);
}

void in_a_pair(ros::Publisher& pub) {
  sensor_msgs::Image image;
  grow({&image.data, 5000});
  pub.publish(image);
}

void in_a_pair_that_is_converted(ros::Publisher& pub) {
  sensor_msgs::Image image;
  const auto named = std::make_pair(&image.data, size_t(5000));
  grow(named);
  pub.publish(image);
}

void in_a_map(ros::Publisher& pub) {
  sensor_msgs::Image image;
  std::map<int, void*> users;
  users.insert(std::make_pair(1, &image.data));
  static_cast<std::vector<uint8_t>*>(users[1])->assign(100, 7);
  pub.publish(image);
}

void run(ros::NodeHandle& nh) {
  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
  in_a_variable(pub);
  in_a_container(pub);
  in_a_pair(pub);
  in_a_pair_that_is_converted(pub);
  in_a_map(pub);
}
//--- expected
// publish src/node.cpp:17 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes a 'void *', which does not tell that an array lies there
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes a 'value_type', which does not tell that an array lies there
// publish src/node.cpp:31 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data becomes a 'std::pair<void *, size_t>', which does not tell that an array lies there
// publish src/node.cpp:38 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'std::make_pair'
// publish src/node.cpp:46 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is passed to 'std::make_pair'
// advertise src/node.cpp:50 sensor_msgs/Image one_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -void in_a_variable(ros::Publisher& pub) {
// +void in_a_variable(tzc::Publisher& pub) {
// -void in_a_container(ros::Publisher& pub) {
// +void in_a_container(tzc::Publisher& pub) {
// -void in_a_pair(ros::Publisher& pub) {
// +void in_a_pair(tzc::Publisher& pub) {
// -void in_a_pair_that_is_converted(ros::Publisher& pub) {
// +void in_a_pair_that_is_converted(tzc::Publisher& pub) {
// -void in_a_map(ros::Publisher& pub) {
// +void in_a_map(tzc::Publisher& pub) {
// -  ros::Publisher pub = nh.advertise<sensor_msgs::Image>("image", 10);
// +  tzc::Publisher pub = tzc::advertise<sensor_msgs::Image>(nh, "image", 10);

// What one turn of a loop published is not what the next one writes to: a second run, whose arrays are of another class, says the same.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>

ros::Publisher one, two, three;
void step(int k) {
  for (int turn = 0; turn < 2; ++turn) {
    sensor_msgs::PointCloud msg;
    msg.channels.resize(1);
    one.publish(msg);
    msg.channels[0].values[0] = 7.5f;
    one.publish(msg);
  }
}
void step2(int k) {
  for (int turn = 0; turn < 2; ++turn) {
    sensor_msgs::PointCloud msg;
    msg.points.resize(10);
    two.publish(msg);
    msg.points[0].x = 7.5f;
    two.publish(msg);
  }
}
void step3(const sensor_msgs::ChannelFloat32& made) {
  for (int turn = 0; turn < 2; ++turn) {
    sensor_msgs::PointCloud msg;
    msg.channels.emplace_back(made);
    three.publish(msg);
    msg.channels[0].values[0] = 7.5f;
    three.publish(msg);
  }
}
int main() {
  ros::NodeHandle nh;
  one = nh.advertise<sensor_msgs::PointCloud>("one", 10);
  two = nh.advertise<sensor_msgs::PointCloud>("two", 10);
  three = nh.advertise<sensor_msgs::PointCloud>("three", 10);
  step(1);
  step2(2);
  sensor_msgs::ChannelFloat32 made;
  step3(made);
}
//--- expected
// publish src/node.cpp:10 sensor_msgs/PointCloud one_copy 'one' TZC1022 line 11 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:12 sensor_msgs/PointCloud zero_copy 'one'
// publish src/node.cpp:19 sensor_msgs/PointCloud one_copy 'two' TZC1022 line 20 may use its elements for writing after this publish, which copies them
// publish src/node.cpp:21 sensor_msgs/PointCloud zero_copy 'two'
// publish src/node.cpp:28 sensor_msgs/PointCloud one_copy 'three' TZC1022 line 27 gives it elements that lie outside shared memory
// publish src/node.cpp:30 sensor_msgs/PointCloud one_copy 'three' TZC1022 line 29 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:35 sensor_msgs/PointCloud zero_copy 'one'
// advertise src/node.cpp:36 sensor_msgs/PointCloud zero_copy 'two'
// advertise src/node.cpp:37 sensor_msgs/PointCloud one_copy 'three'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/ChannelFloat32.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -ros::Publisher one, two, three;
// +tzc::Publisher one, two, three;
// -    sensor_msgs::PointCloud msg;
// +    tzc::sensor_msgs::PointCloud msg;
// +    one.allocate(msg);
// -    sensor_msgs::PointCloud msg;
// +    tzc::sensor_msgs::PointCloud msg;
// +    two.allocate(msg);
// -void step3(const sensor_msgs::ChannelFloat32& made) {
// +void step3(const tzc::sensor_msgs::ChannelFloat32& made) {
// -    sensor_msgs::PointCloud msg;
// +    tzc::sensor_msgs::PointCloud msg;
// +    three.allocate(msg);
// -  one = nh.advertise<sensor_msgs::PointCloud>("one", 10);
// -  two = nh.advertise<sensor_msgs::PointCloud>("two", 10);
// -  three = nh.advertise<sensor_msgs::PointCloud>("three", 10);
// +  one = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "one", 10);
// +  two = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "two", 10);
// +  three = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "three", 10);
// -  sensor_msgs::ChannelFloat32 made;
// +  tzc::sensor_msgs::ChannelFloat32 made;
// +  three.allocate(made);

// What adds more elements than the twin may bind, moves them in, or adds them by another name: their arrays lie outside shared memory.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>

ros::Publisher resized, filled, pushed, moved, made, assigned, inserted, looped, referred, passed;

void resize(int n) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(n);
  cloud.channels.resize(n);
  cloud.channels[0].values.resize(n);
  resized.publish(cloud);
}

void fill(const sensor_msgs::ChannelFloat32& channel) {
  sensor_msgs::PointCloud cloud;
  cloud.channels.resize(2, channel);
  filled.publish(cloud);
}

void push() {
  sensor_msgs::ChannelFloat32 channel;
  channel.values.resize(100);
  sensor_msgs::PointCloud cloud;
  cloud.channels.push_back(std::move(channel));
  pushed.publish(cloud);
}

sensor_msgs::ChannelFloat32 make_channel() {
  sensor_msgs::ChannelFloat32 channel;
  channel.values.resize(100);
  return channel;
}

void move() {
  sensor_msgs::PointCloud cloud;
  cloud.channels.push_back(make_channel());
  moved.publish(cloud);
}

void make(const sensor_msgs::ChannelFloat32& channel) {
  sensor_msgs::PointCloud cloud;
  cloud.channels.emplace_back(channel);
  made.publish(cloud);
}

void assign(const std::vector<sensor_msgs::ChannelFloat32>& channels) {
  sensor_msgs::PointCloud cloud;
  cloud.channels.assign(channels.begin(), channels.end());
  assigned.publish(cloud);
}

void insert(const sensor_msgs::ChannelFloat32& channel) {
  sensor_msgs::PointCloud cloud;
  cloud.channels.insert(cloud.channels.end(), channel);
  inserted.publish(cloud);
}

void loop(const std::vector<sensor_msgs::ChannelFloat32>& channels) {
  sensor_msgs::PointCloud cloud;
  cloud.points.resize(10);
  for (const auto& channel : channels) cloud.channels.emplace_back().name = channel.name;
  looped.publish(cloud);
}

void refer(int n) {
  sensor_msgs::PointCloud cloud;
  std::vector<sensor_msgs::ChannelFloat32>& channels = cloud.channels;
  cloud.points.resize(n);
  channels.resize(2);
  channels[0].values.resize(n);
  referred.publish(cloud);
}

void add(std::vector<sensor_msgs::ChannelFloat32>& channels, int n) {
  channels.resize(2);
  channels[0].values.resize(n);
}

void pass(int n) {
  sensor_msgs::PointCloud cloud;
  add(cloud.channels, n);
  passed.publish(cloud);
}

int main() {
  ros::NodeHandle nh;
  resized = nh.advertise<sensor_msgs::PointCloud>("resized", 10);
  filled = nh.advertise<sensor_msgs::PointCloud>("filled", 10);
  pushed = nh.advertise<sensor_msgs::PointCloud>("pushed", 10);
  moved = nh.advertise<sensor_msgs::PointCloud>("moved", 10);
  made = nh.advertise<sensor_msgs::PointCloud>("made", 10);
  assigned = nh.advertise<sensor_msgs::PointCloud>("assigned", 10);
  inserted = nh.advertise<sensor_msgs::PointCloud>("inserted", 10);
  looped = nh.advertise<sensor_msgs::PointCloud>("looped", 10);
  referred = nh.advertise<sensor_msgs::PointCloud>("referred", 10);
  passed = nh.advertise<sensor_msgs::PointCloud>("passed", 10);
}
//--- expected
// publish src/node.cpp:12 sensor_msgs/PointCloud one_copy 'resized' TZC1022 line 10 gives it elements that lie outside shared memory
// publish src/node.cpp:18 sensor_msgs/PointCloud one_copy 'filled' TZC1022 line 17 gives it elements that lie outside shared memory
// publish src/node.cpp:26 sensor_msgs/PointCloud one_copy 'pushed' TZC1022 line 25 gives it elements that lie outside shared memory
// publish src/node.cpp:38 sensor_msgs/PointCloud one_copy 'moved' TZC1022 line 37 gives it elements that lie outside shared memory
// publish src/node.cpp:44 sensor_msgs/PointCloud one_copy 'made' TZC1022 line 43 gives it elements that lie outside shared memory
// publish src/node.cpp:50 sensor_msgs/PointCloud one_copy 'assigned' TZC1022 line 49 gives it elements that lie outside shared memory
// publish src/node.cpp:56 sensor_msgs/PointCloud one_copy 'inserted' TZC1022 line 55 gives it elements that lie outside shared memory
// publish src/node.cpp:63 sensor_msgs/PointCloud one_copy 'looped' TZC1022 line 62 gives it elements that lie outside shared memory
// publish src/node.cpp:72 sensor_msgs/PointCloud one_copy 'referred' TZC1022 line 70 gives it elements that lie outside shared memory
// publish src/node.cpp:83 sensor_msgs/PointCloud one_copy 'passed' TZC1022 line 82 gives it elements that lie outside shared memory
// advertise src/node.cpp:88 sensor_msgs/PointCloud one_copy 'resized'
// advertise src/node.cpp:89 sensor_msgs/PointCloud one_copy 'filled'
// advertise src/node.cpp:90 sensor_msgs/PointCloud one_copy 'pushed'
// advertise src/node.cpp:91 sensor_msgs/PointCloud one_copy 'moved'
// advertise src/node.cpp:92 sensor_msgs/PointCloud one_copy 'made'
// advertise src/node.cpp:93 sensor_msgs/PointCloud one_copy 'assigned'
// advertise src/node.cpp:94 sensor_msgs/PointCloud one_copy 'inserted'
// advertise src/node.cpp:95 sensor_msgs/PointCloud one_copy 'looped'
// advertise src/node.cpp:96 sensor_msgs/PointCloud one_copy 'referred'
// advertise src/node.cpp:97 sensor_msgs/PointCloud one_copy 'passed'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/ChannelFloat32.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -ros::Publisher resized, filled, pushed, moved, made, assigned, inserted, looped, referred, passed;
// +tzc::Publisher resized, filled, pushed, moved, made, assigned, inserted, looped, referred, passed;
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  resized.allocate(cloud);
// -void fill(const sensor_msgs::ChannelFloat32& channel) {
// -  sensor_msgs::PointCloud cloud;
// +void fill(const tzc::sensor_msgs::ChannelFloat32& channel) {
// +  tzc::sensor_msgs::PointCloud cloud;
// +  filled.allocate(cloud);
// -  sensor_msgs::ChannelFloat32 channel;
// +  tzc::sensor_msgs::ChannelFloat32 channel;
// +  pushed.allocate(channel);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  pushed.allocate(cloud);
// -sensor_msgs::ChannelFloat32 make_channel() {
// -  sensor_msgs::ChannelFloat32 channel;
// +tzc::sensor_msgs::ChannelFloat32 make_channel() {
// +  tzc::sensor_msgs::ChannelFloat32 channel;
// +  moved.allocate(channel);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  moved.allocate(cloud);
// -void make(const sensor_msgs::ChannelFloat32& channel) {
// -  sensor_msgs::PointCloud cloud;
// +void make(const tzc::sensor_msgs::ChannelFloat32& channel) {
// +  tzc::sensor_msgs::PointCloud cloud;
// +  made.allocate(cloud);
// -void assign(const std::vector<sensor_msgs::ChannelFloat32>& channels) {
// -  sensor_msgs::PointCloud cloud;
// +void assign(const std::vector<tzc::sensor_msgs::ChannelFloat32>& channels) {
// +  tzc::sensor_msgs::PointCloud cloud;
// +  assigned.allocate(cloud);
// -void insert(const sensor_msgs::ChannelFloat32& channel) {
// -  sensor_msgs::PointCloud cloud;
// +void insert(const tzc::sensor_msgs::ChannelFloat32& channel) {
// +  tzc::sensor_msgs::PointCloud cloud;
// +  inserted.allocate(cloud);
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  looped.allocate(cloud);
// -  sensor_msgs::PointCloud cloud;
// -  std::vector<sensor_msgs::ChannelFloat32>& channels = cloud.channels;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  referred.allocate(cloud);
// +  std::vector<tzc::sensor_msgs::ChannelFloat32>& channels = cloud.channels;
// -void add(std::vector<sensor_msgs::ChannelFloat32>& channels, int n) {
// +void add(std::vector<tzc::sensor_msgs::ChannelFloat32>& channels, int n) {
// -  sensor_msgs::PointCloud cloud;
// +  tzc::sensor_msgs::PointCloud cloud;
// +  passed.allocate(cloud);
// -  resized = nh.advertise<sensor_msgs::PointCloud>("resized", 10);
// -  filled = nh.advertise<sensor_msgs::PointCloud>("filled", 10);
// -  pushed = nh.advertise<sensor_msgs::PointCloud>("pushed", 10);
// -  moved = nh.advertise<sensor_msgs::PointCloud>("moved", 10);
// -  made = nh.advertise<sensor_msgs::PointCloud>("made", 10);
// -  assigned = nh.advertise<sensor_msgs::PointCloud>("assigned", 10);
// -  inserted = nh.advertise<sensor_msgs::PointCloud>("inserted", 10);
// -  looped = nh.advertise<sensor_msgs::PointCloud>("looped", 10);
// -  referred = nh.advertise<sensor_msgs::PointCloud>("referred", 10);
// -  passed = nh.advertise<sensor_msgs::PointCloud>("passed", 10);
// +  resized = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "resized", 10);
// +  filled = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "filled", 10);
// +  pushed = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "pushed", 10);
// +  moved = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "moved", 10);
// +  made = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "made", 10);
// +  assigned = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "assigned", 10);
// +  inserted = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "inserted", 10);
// +  looped = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "looped", 10);
// +  referred = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "referred", 10);
// +  passed = tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "passed", 10);

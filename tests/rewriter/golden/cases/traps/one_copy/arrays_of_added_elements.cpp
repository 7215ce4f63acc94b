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

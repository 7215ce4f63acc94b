// The twin binds the elements that are added to a message's own array of messages: their arrays grow in shared memory, too.
#include <ros/ros.h>
#include <sensor_msgs/PointCloud.h>

class Driver {
 public:
  explicit Driver(ros::NodeHandle& nh)
      : local_(nh.advertise<sensor_msgs::PointCloud>("local", 10)),
        lasting_(nh.advertise<sensor_msgs::PointCloud>("lasting", 10)),
        pushed_(nh.advertise<sensor_msgs::PointCloud>("pushed", 10)),
        looped_(nh.advertise<sensor_msgs::PointCloud>("looped", 10)) {}

  void publish_local(int n) {
    sensor_msgs::PointCloud cloud;
    cloud.points.resize(n);
    auto& channels = cloud.channels;
    channels.resize(1);
    channels[0].name = "intensities";
    channels[0].values.resize(n);
    local_.publish(cloud);
  }

  void publish_lasting(int n) {
    cloud_.points.clear();
    cloud_.channels.clear();
    cloud_.channels.resize(2);
    for (auto& channel : cloud_.channels) channel.values.resize(n);
    lasting_.publish(cloud_);
  }

  void publish_pushed(int n) {
    sensor_msgs::PointCloudPtr cloud(new sensor_msgs::PointCloud);
    sensor_msgs::ChannelFloat32 ids, angles;
    for (int i = 0; i < n; ++i) {
      ids.values.push_back(i);
      angles.values.push_back(0.1 * i);
    }
    cloud->channels.push_back(ids);
    cloud->channels.push_back(angles);
    cloud->channels.emplace_back();
    pushed_.publish(cloud);
  }

  void publish_looped(int n) {
    while (ros::ok()) {
      sensor_msgs::PointCloud cloud;
      cloud.channels.emplace_back();
      cloud.channels.back().values.assign(n, 0);
      looped_.publish(cloud);
    }
  }

 private:
  ros::Publisher local_, lasting_, pushed_, looped_;
  sensor_msgs::PointCloud cloud_;
};

int main() {
  ros::NodeHandle nh;
  Driver driver(nh);
  while (ros::ok()) {
    driver.publish_local(100);
    driver.publish_lasting(100);
    driver.publish_pushed(100);
    driver.publish_looped(100);
  }
}
//--- expected
// advertise src/node.cpp:8 sensor_msgs/PointCloud zero_copy 'local'
// advertise src/node.cpp:9 sensor_msgs/PointCloud zero_copy 'lasting'
// advertise src/node.cpp:10 sensor_msgs/PointCloud zero_copy 'pushed'
// advertise src/node.cpp:11 sensor_msgs/PointCloud zero_copy 'looped'
// publish src/node.cpp:20 sensor_msgs/PointCloud zero_copy 'local'
// publish src/node.cpp:28 sensor_msgs/PointCloud zero_copy 'lasting'
// publish src/node.cpp:41 sensor_msgs/PointCloud zero_copy 'pushed'
// publish src/node.cpp:49 sensor_msgs/PointCloud zero_copy 'looped'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/ChannelFloat32.h>
// +#include <tzc/sensor_msgs/PointCloud.h>
// -      : local_(nh.advertise<sensor_msgs::PointCloud>("local", 10)),
// -        lasting_(nh.advertise<sensor_msgs::PointCloud>("lasting", 10)),
// -        pushed_(nh.advertise<sensor_msgs::PointCloud>("pushed", 10)),
// -        looped_(nh.advertise<sensor_msgs::PointCloud>("looped", 10)) {}
// +      : local_(tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "local", 10)),
// +        lasting_(tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "lasting", 10)),
// +        pushed_(tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "pushed", 10)),
// +        looped_(tzc::advertise<tzc::sensor_msgs::PointCloud>(nh, "looped", 10)) {}
// -    sensor_msgs::PointCloud cloud;
// +    tzc::sensor_msgs::PointCloud cloud;
// +    local_.allocate(cloud);
// -    sensor_msgs::PointCloudPtr cloud(new sensor_msgs::PointCloud);
// -    sensor_msgs::ChannelFloat32 ids, angles;
// +    tzc::sensor_msgs::PointCloudPtr cloud(new tzc::sensor_msgs::PointCloud);
// +    pushed_.allocate(*cloud);
// +    tzc::sensor_msgs::ChannelFloat32 ids, angles;
// -      sensor_msgs::PointCloud cloud;
// +      tzc::sensor_msgs::PointCloud cloud;
// +      looped_.allocate(cloud);
// -  ros::Publisher local_, lasting_, pushed_, looped_;
// -  sensor_msgs::PointCloud cloud_;
// +  tzc::Publisher local_, lasting_, pushed_, looped_;
// +  tzc::sensor_msgs::PointCloud cloud_;

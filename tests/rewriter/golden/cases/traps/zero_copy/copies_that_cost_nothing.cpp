// Copies of what is empty have no elements; copies of what was published share them; and what is assigned to a message in shared memory lies there.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

#include <vector>

sensor_msgs::PointCloud2 thinned(const sensor_msgs::PointCloud2& in) {
  if (in.data.empty()) return in;
  if (0 == in.data.size()) return in;
  if (in.data.size() == 0) {
    return in;
  }
  sensor_msgs::PointCloud2 out;
  out.data.resize(in.data.size() / 2);
  return out;
}

class Empty {
 public:
  explicit Empty(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("empty", 1)) {}
  void tick(std::size_t size) {
    sensor_msgs::PointCloud2 cloud;
    cloud.data.resize(size);
    pub_.publish(thinned(cloud));
  }

 private:
  ros::Publisher pub_;
};

class Again {
 public:
  explicit Again(ros::NodeHandle& nh)
      : pub_(nh.advertise<sensor_msgs::Image>("once", 1)), all_(nh.advertise<sensor_msgs::Image>("again", 1)) {}
  void tick() {
    sensor_msgs::Image image;
    image.data.resize(6000);
    pub_.publish(image);
    kept_.push_back(image);
    for (const auto& each : kept_) all_.publish(each);
  }

 private:
  ros::Publisher pub_, all_;
  std::vector<sensor_msgs::Image> kept_;
};

class Assigned {
 public:
  explicit Assigned(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("assigned", 1)) {}
  void callback(const sensor_msgs::ImageConstPtr& in) {
    sensor_msgs::Image image;
    image = *in;
    pub_.publish(image);
  }

 private:
  ros::Publisher pub_;
};

int main() {
  ros::NodeHandle nh;
  Empty(nh).tick(0);
  Again(nh).tick();
  Assigned assigned(nh);
  const auto image = nh.subscribe("image", 1, &Assigned::callback, &assigned);
  ros::spin();
}
//--- expected
// advertise src/node.cpp:21 sensor_msgs/PointCloud2 zero_copy 'empty'
// publish src/node.cpp:25 sensor_msgs/PointCloud2 zero_copy 'empty'
// advertise src/node.cpp:35 sensor_msgs/Image zero_copy 'once'
// advertise src/node.cpp:35 sensor_msgs/Image zero_copy 'again'
// publish src/node.cpp:39 sensor_msgs/Image zero_copy 'once'
// publish src/node.cpp:41 sensor_msgs/Image zero_copy 'again'
// advertise src/node.cpp:51 sensor_msgs/Image zero_copy 'assigned'
// publish src/node.cpp:55 sensor_msgs/Image zero_copy 'assigned'
// subscribe src/node.cpp:67 sensor_msgs/Image shared 'image'
//
// +++ src/node.cpp
// +#include <tzc/sensor_msgs/Image.h>
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -sensor_msgs::PointCloud2 thinned(const sensor_msgs::PointCloud2& in) {
// +tzc::sensor_msgs::PointCloud2 thinned(const tzc::Publisher& publisher, const tzc::sensor_msgs::PointCloud2& in) {
// -  sensor_msgs::PointCloud2 out;
// +  tzc::sensor_msgs::PointCloud2 out;
// +  publisher.allocate(out);
// -  explicit Empty(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::PointCloud2>("empty", 1)) {}
// +  explicit Empty(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh, "empty", 1)) {}
// -    sensor_msgs::PointCloud2 cloud;
// +    tzc::sensor_msgs::PointCloud2 cloud;
// +    pub_.allocate(cloud);
// -    pub_.publish(thinned(cloud));
// +    pub_.publish(thinned(pub_, cloud));
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -      : pub_(nh.advertise<sensor_msgs::Image>("once", 1)), all_(nh.advertise<sensor_msgs::Image>("again", 1)) {}
// +      : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "once", 1)), all_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "again", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_, all_;
// -  std::vector<sensor_msgs::Image> kept_;
// +  tzc::Publisher pub_, all_;
// +  std::vector<tzc::sensor_msgs::Image> kept_;
// -  explicit Assigned(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("assigned", 1)) {}
// +  explicit Assigned(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "assigned", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// +  tzc::Publisher pub_;
// -  const auto image = nh.subscribe("image", 1, &Assigned::callback, &assigned);
// +  const auto image = tzc::subscribe(nh, "image", 1, &Assigned::callback, &assigned);

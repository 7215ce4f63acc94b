// An override casts the const of what it is given away.
#include <vector>

#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

struct Filter {
  virtual ~Filter() = default;
  virtual void apply(const std::vector<uint8_t>& bytes) = 0;
};
struct Trim : Filter {
  void apply(const std::vector<uint8_t>& bytes) override {
    const_cast<std::vector<uint8_t>&>(bytes).resize(30000);
  }
};

Filter* filter = new Trim;
void on_cloud(const sensor_msgs::PointCloud2ConstPtr& cloud) { filter->apply(cloud->data); }

void run(ros::NodeHandle& nh) { ros::Subscriber clouds = nh.subscribe("cloud", 1, on_cloud); }
//--- expected
// subscribe src/node.cpp:20 sensor_msgs/PointCloud2 plain 'cloud' TZC2002 const is cast away from an array that may be one of this message's

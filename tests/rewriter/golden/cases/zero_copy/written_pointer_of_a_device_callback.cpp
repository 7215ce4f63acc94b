// A device calls back on any thread: who writes through a pointer at once needs no lock, because publishing meanwhile is an error already.
// What it looks at has functions that the package overrides, and calls none of them.
#include <other/library.h>
#include <ros/ros.h>
#include <sensor_msgs/PointCloud2.h>

#include <mutex>
#include <vector>

struct Own : other::Source {
  void fill(sensor_msgs::Image&) override { other::poll(); }
};

class Driver {
 public:
  Driver() {
    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
    other::post([this] { fill({&source_}, 3); });
  }

 private:
  void fill(const std::vector<other::Source*>& sources, unsigned count) {
    {
      std::lock_guard<std::mutex> lock(counter_mutex_);
      calls_ += 1;
    }
    if (count > 0) {
      cloud_.data.resize((cloud_.width + count) * 8);
      float* data = reinterpret_cast<float*>(&cloud_.data[0]);
      data += cloud_.width * 2;
      for (unsigned i = 0; i < count; ++i) {
        *(data++) = sources[i] ? 2.0f : 3.0f;
        data[0] = 1;
        ++data;
      }
      cloud_.width += count;
    }
    publish_if_done();
  }
  void publish_if_done() {
    if (cloud_.width < 100) return;
    pub_.publish(cloud_);
    cloud_.width = 0;
    cloud_.data.clear();
  }

  ros::NodeHandle nh_;
  ros::Publisher pub_;
  sensor_msgs::PointCloud2 cloud_;
  Own source_;
  std::mutex counter_mutex_;
  int calls_ = 0;
};
//--- expected
// advertise src/node.cpp:17 sensor_msgs/PointCloud2 zero_copy 'points'
// publish src/node.cpp:42 sensor_msgs/PointCloud2 zero_copy 'points'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/PointCloud2.h>
// -    pub_ = nh_.advertise<sensor_msgs::PointCloud2>("points", 5);
// +    pub_ = tzc::advertise<tzc::sensor_msgs::PointCloud2>(nh_, "points", 5);
// -  ros::Publisher pub_;
// -  sensor_msgs::PointCloud2 cloud_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::PointCloud2 cloud_;

// Pointers into the data stand beside what only leads to objects of the package: none of their functions run.
#include <cstring>
#include <map>
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

struct Source {
  Source() { ++made; }
  Source(const Source&) { ++made; }
  ~Source() { --made; }
  bool operator==(const Source&) const { return true; }
  unsigned char pixel = 0;
  static int made;
};
int Source::made = 0;

class Node {
 public:
  void tick() {
    image_.data.assign(10000, 1);
    std::memcpy(&image_.data[0], &shared_->pixel, 1);
    std::memcpy(&image_.data[1], &(*boost_).pixel, 1);
    std::memcpy(&image_.data[2], &owned_.get()->pixel, owned_ != nullptr ? 1 : 0);
    std::memcpy(&image_.data[3], &sources_[2].pixel, sources_.size());
    std::memcpy(&image_.data[4], &sources_.begin()->pixel, sources_.begin() == sources_.end() ? 0 : 1);
    std::memcpy(&image_.data[5], &named_.begin()->second.pixel, 1);
    unsigned char* at = &image_.data[6];
    for (int i = 0; i < 3; ++i) *at++ = array_[i].pixel + shared_array_[i].pixel;
    pub_.publish(image_);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
  sensor_msgs::Image image_;
  std::shared_ptr<Source> shared_ = std::make_shared<Source>();
  boost::shared_ptr<Source> boost_ = boost::make_shared<Source>();
  std::unique_ptr<Source> owned_ = std::make_unique<Source>();
  std::vector<Source> sources_{3};
  std::map<int, Source> named_;
  std::unique_ptr<Source[]> array_{new Source[3]};
  std::shared_ptr<Source[]> shared_array_{new Source[3]};
};
//--- expected
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:36 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  ros::Publisher pub_ = nh_.advertise<sensor_msgs::Image>("image", 1);
// -  sensor_msgs::Image image_;
// +  tzc::Publisher pub_ = tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1);
// +  tzc::sensor_msgs::Image image_;

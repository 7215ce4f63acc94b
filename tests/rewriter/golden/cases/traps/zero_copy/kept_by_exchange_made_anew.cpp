// Two buffers change places, and what is written is made anew.
#include <memory>
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Arrays {
 public:
  explicit Arrays(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("arrays", 1)) {}
  void tick(int k) {
    back_.data.assign(6000, k);
    back_.data[k] = 1;
    front_.data.swap(back_.data);
    pub_.publish(front_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image front_, back_;
};

class Messages {
 public:
  explicit Messages(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("messages", 1)) {}
  void tick(int k) {
    back_.data.assign(6000, k);
    back_.data[k] = 1;
    std::swap(front_, back_);
    pub_.publish(front_);
  }

 private:
  ros::Publisher pub_;
  sensor_msgs::Image front_, back_;
};

class Kept {
 public:
  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {}
  void tick(int k) {
    std::shared_ptr<sensor_msgs::Image> image = std::make_shared<sensor_msgs::Image>();
    image->data.resize(6000);
    last_ = image;
    last_->data[k] = 1;
    pub_.publish(*last_);
  }

 private:
  ros::Publisher pub_;
  std::shared_ptr<sensor_msgs::Image> last_;
};

int main() {
  ros::NodeHandle nh;
  Arrays arrays(nh);
  Messages messages(nh);
  Kept kept(nh);
  for (int k = 0; k < 9; ++k) {
    arrays.tick(k);
    messages.tick(k);
    kept.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image zero_copy 'arrays'
// publish src/node.cpp:15 sensor_msgs/Image zero_copy 'arrays'
// advertise src/node.cpp:25 sensor_msgs/Image zero_copy 'messages'
// publish src/node.cpp:30 sensor_msgs/Image zero_copy 'messages'
// advertise src/node.cpp:40 sensor_msgs/Image zero_copy 'kept'
// publish src/node.cpp:46 sensor_msgs/Image zero_copy 'kept'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Arrays(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("arrays", 1)) {}
// +  explicit Arrays(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "arrays", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image front_, back_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image front_, back_;
// -  explicit Messages(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("messages", 1)) {}
// +  explicit Messages(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "messages", 1)) {}
// -  ros::Publisher pub_;
// -  sensor_msgs::Image front_, back_;
// +  tzc::Publisher pub_;
// +  tzc::sensor_msgs::Image front_, back_;
// -  explicit Kept(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("kept", 1)) {}
// +  explicit Kept(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "kept", 1)) {}
// -    std::shared_ptr<sensor_msgs::Image> image = std::make_shared<sensor_msgs::Image>();
// +    std::shared_ptr<tzc::sensor_msgs::Image> image = std::make_shared<tzc::sensor_msgs::Image>();
// +    pub_.allocate(*image);
// -  ros::Publisher pub_;
// -  std::shared_ptr<sensor_msgs::Image> last_;
// +  tzc::Publisher pub_;
// +  std::shared_ptr<tzc::sensor_msgs::Image> last_;

// Two pointers change places, so what is written is what was published the time before.
#include <memory>
#include <utility>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Methods {
 public:
  explicit Methods(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("methods", 1)) {
    front_.reset(new sensor_msgs::Image);
    back_.reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    back_->data.resize(6000);
    back_->data[k] = 1;
    front_.swap(back_);
    pub_.publish(*front_);
  }

 private:
  ros::Publisher pub_;
  std::shared_ptr<sensor_msgs::Image> front_, back_;
};

class Functions {
 public:
  explicit Functions(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("functions", 1)) {
    front_.reset(new sensor_msgs::Image);
    back_.reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    back_->data.resize(6000);
    back_->data[k] = 1;
    std::swap(front_, back_);
    pub_.publish(*front_);
  }

 private:
  ros::Publisher pub_;
  std::shared_ptr<sensor_msgs::Image> front_, back_;
};

class Turned {
 public:
  explicit Turned(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("turned", 1)) {
    front_.reset(new sensor_msgs::Image);
    back_.reset(new sensor_msgs::Image);
  }
  void tick(int k) {
    back_->data.resize(6000);
    back_->data[k] = 1;
    std::shared_ptr<sensor_msgs::Image> last = front_;
    front_ = back_;
    back_ = last;
    pub_.publish(*front_);
  }

 private:
  ros::Publisher pub_;
  std::shared_ptr<sensor_msgs::Image> front_, back_;
};

int main() {
  ros::NodeHandle nh;
  Methods methods(nh);
  Functions functions(nh);
  Turned turned(nh);
  for (int k = 0; k < 9; ++k) {
    methods.tick(k);
    functions.tick(k);
    turned.tick(k);
  }
}
//--- expected
// advertise src/node.cpp:10 sensor_msgs/Image one_copy 'methods'
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'methods' TZC1022 line 16 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:28 sensor_msgs/Image one_copy 'functions'
// publish src/node.cpp:36 sensor_msgs/Image one_copy 'functions' TZC1022 line 34 may use its elements for writing after this publish, which copies them
// advertise src/node.cpp:46 sensor_msgs/Image one_copy 'turned'
// publish src/node.cpp:56 sensor_msgs/Image one_copy 'turned' TZC1022 line 52 may use its elements for writing after this publish, which copies them
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit Methods(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("methods", 1)) {
// -    front_.reset(new sensor_msgs::Image);
// -    back_.reset(new sensor_msgs::Image);
// +  explicit Methods(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "methods", 1)) {
// +    front_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*front_);
// +    back_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*back_);
// -  ros::Publisher pub_;
// -  std::shared_ptr<sensor_msgs::Image> front_, back_;
// +  tzc::Publisher pub_;
// +  std::shared_ptr<tzc::sensor_msgs::Image> front_, back_;
// -  explicit Functions(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("functions", 1)) {
// -    front_.reset(new sensor_msgs::Image);
// -    back_.reset(new sensor_msgs::Image);
// +  explicit Functions(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "functions", 1)) {
// +    front_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*front_);
// +    back_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*back_);
// -  ros::Publisher pub_;
// -  std::shared_ptr<sensor_msgs::Image> front_, back_;
// +  tzc::Publisher pub_;
// +  std::shared_ptr<tzc::sensor_msgs::Image> front_, back_;
// -  explicit Turned(ros::NodeHandle& nh) : pub_(nh.advertise<sensor_msgs::Image>("turned", 1)) {
// -    front_.reset(new sensor_msgs::Image);
// -    back_.reset(new sensor_msgs::Image);
// +  explicit Turned(ros::NodeHandle& nh) : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh, "turned", 1)) {
// +    front_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*front_);
// +    back_.reset(new tzc::sensor_msgs::Image);
// +    pub_.allocate(*back_);
// -    std::shared_ptr<sensor_msgs::Image> last = front_;
// +    std::shared_ptr<tzc::sensor_msgs::Image> last = front_;
// -  ros::Publisher pub_;
// -  std::shared_ptr<sensor_msgs::Image> front_, back_;
// +  tzc::Publisher pub_;
// +  std::shared_ptr<tzc::sensor_msgs::Image> front_, back_;

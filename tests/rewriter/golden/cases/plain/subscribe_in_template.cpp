// One instance of the template has a callback that takes the message's memory.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

template <class Derived>
class Listener {
 public:
  explicit Listener(ros::NodeHandle& nh)
      : sub_(nh.subscribe("image", 50, &Derived::callback, static_cast<Derived*>(this))) {}

 private:
  ros::Subscriber sub_;
};

class Reader : public Listener<Reader> {
 public:
  using Listener::Listener;
  void callback(const sensor_msgs::ImageConstPtr& image) { size_ = image->data.size(); }

 private:
  std::size_t size_ = 0;
};

class Thief : public Listener<Thief> {
 public:
  using Listener::Listener;
  void callback(const sensor_msgs::ImageConstPtr& image) {
    pixels_.swap(const_cast<sensor_msgs::Image&>(*image).data);
  }

 private:
  std::vector<uint8_t> pixels_;
};

void run(ros::NodeHandle& nh) {
  Reader reader(nh);
  Thief thief(nh);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it

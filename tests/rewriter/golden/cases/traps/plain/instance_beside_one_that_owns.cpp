// One instance of the template takes the message as its own; the other one takes away what it shares with callbacks of its topic.
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

class Owner : public Listener<Owner> {
 public:
  using Listener::Listener;
  void callback(const sensor_msgs::ImagePtr& image) { pixels_.swap(image->data); }

 private:
  std::vector<uint8_t> pixels_;
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
  Owner owner(nh);
  Thief thief(nh);
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:9 sensor_msgs/Image plain 'image' TZC2002 const is cast away from it

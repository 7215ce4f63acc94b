// A class template's own name for its filter means another class in each instance: its text stays.
#include <string>

#include <message_filters/subscriber.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/PointCloud2.h>

template <class M>
class Input {
  typedef message_filters::Subscriber<M> Sub;

 public:
  Input(ros::NodeHandle& nh, const std::string& topic) : sub_(nh, topic, 5) {
    sub_.registerCallback(&Input::on, this);
  }
  void on(const boost::shared_ptr<M const>& message) { last_ = message; }

 private:
  Sub sub_;
  boost::shared_ptr<M const> last_;
};

int main() {
  ros::NodeHandle nh;
  Input<sensor_msgs::Image> image(nh, "image");
  Input<sensor_msgs::PointCloud2> cloud(nh, "cloud");
  ros::spin();
}
//--- expected
// subscribe src/node.cpp:14 sensor_msgs/Image plain TZC1007 the name 'Sub' means another type in each instance of a template
// subscribe src/node.cpp:14 sensor_msgs/PointCloud2 plain TZC1007 the name 'Sub' means another type in each instance of a template

// A class that converts to a pointer does so in a function of the package, which is looked at as any other; one that is derived from the
// pointer is one. Neither says anything of received messages.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

class Tagged {
 public:
  explicit operator sensor_msgs::ImagePtr() const {
    auto image = boost::make_shared<sensor_msgs::Image>();
    image->header.frame_id = tag;
    image->data.resize(100);
    return image;
  }
  std::string tag;
};
struct Loan : sensor_msgs::ImagePtr {
  Loan() : sensor_msgs::ImagePtr(new sensor_msgs::Image) {}
};

ros::Publisher pub, loans;

void take(const sensor_msgs::ImageConstPtr& in) {
  Tagged tagged;
  tagged.tag = in->header.frame_id;
  pub.publish(static_cast<sensor_msgs::ImagePtr>(tagged));
  pub.publish(sensor_msgs::ImagePtr(tagged));
  Loan loan;
  loan->data.resize(100);
  loans.publish(sensor_msgs::ImagePtr(loan));
}

int main() {
  ros::NodeHandle nh;
  pub = nh.advertise<sensor_msgs::Image>("tagged", 1);
  loans = nh.advertise<sensor_msgs::Image>("loans", 1);
  ros::Subscriber sub = nh.subscribe("in", 1, take);
}
//--- expected
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'tagged'
// publish src/node.cpp:26 sensor_msgs/Image zero_copy 'tagged'
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'loans' TZC1001 it is the part of an object of 'Loan'
// advertise src/node.cpp:34 sensor_msgs/Image zero_copy 'tagged'
// advertise src/node.cpp:35 sensor_msgs/Image one_copy 'loans'
// subscribe src/node.cpp:36 sensor_msgs/Image shared 'in'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  explicit operator sensor_msgs::ImagePtr() const {
// -    auto image = boost::make_shared<sensor_msgs::Image>();
// +  explicit operator tzc::sensor_msgs::ImagePtr() const {
// +    auto image = boost::make_shared<tzc::sensor_msgs::Image>();
// +    tzc::allocate(*image);
// -ros::Publisher pub, loans;
// +tzc::Publisher pub, loans;
// -  pub.publish(static_cast<sensor_msgs::ImagePtr>(tagged));
// -  pub.publish(sensor_msgs::ImagePtr(tagged));
// +  pub.publish(static_cast<tzc::sensor_msgs::ImagePtr>(tagged));
// +  pub.publish(tzc::sensor_msgs::ImagePtr(tagged));
// -  pub = nh.advertise<sensor_msgs::Image>("tagged", 1);
// -  loans = nh.advertise<sensor_msgs::Image>("loans", 1);
// -  ros::Subscriber sub = nh.subscribe("in", 1, take);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "tagged", 1);
// +  loans = tzc::advertise<sensor_msgs::Image>(nh, "loans", 1);
// +  ros::Subscriber sub = tzc::subscribe(nh, "in", 1, take);

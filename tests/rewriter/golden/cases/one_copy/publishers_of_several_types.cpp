// Each instance of a template has a publisher of its own class, which is written once.
#include <image_transport/image_transport.h>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

struct Images {
  typedef sensor_msgs::Image Message;
  typedef image_transport::Publisher Publisher;
  static Publisher advertise(ros::NodeHandle& nh) {
    image_transport::ImageTransport it(nh);
    return it.advertise("image", 1);
  }
};
struct Scans {
  typedef sensor_msgs::LaserScan Message;
  typedef ros::Publisher Publisher;
  static Publisher advertise(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::LaserScan>("scan", 1); }
};

template <class Kind>
class Talker {
 public:
  explicit Talker(ros::NodeHandle& nh) : pub_(Kind::advertise(nh)) {}
  void send(const typename Kind::Message& message) { pub_.publish(message); }

 private:
  typename Kind::Publisher pub_;
};

void run(ros::NodeHandle& nh, const sensor_msgs::Image& image, const sensor_msgs::LaserScan& scan) {
  Talker<Images>(nh).send(image);
  Talker<Scans>(nh).send(scan);
}
//--- expected
// advertise src/node.cpp:12 sensor_msgs/Image one_copy 'image' TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// advertise src/node.cpp:18 sensor_msgs/LaserScan one_copy 'scan' TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// publish src/node.cpp:25 sensor_msgs/Image one_copy TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
// publish src/node.cpp:25 sensor_msgs/LaserScan one_copy TZC1007 its type differs between the instances of a template, or the ways in which the file is compiled
//
// +++ src/node.cpp
// +#include <tzc/image_transport.h>
// +#include <tzc/ros.h>
// -    return it.advertise("image", 1);
// +    return tzc::image_transport::attached(it.advertise("image", 1));
// -  static Publisher advertise(ros::NodeHandle& nh) { return nh.advertise<sensor_msgs::LaserScan>("scan", 1); }
// +  static Publisher advertise(ros::NodeHandle& nh) { return tzc::attached<sensor_msgs::LaserScan>(nh.advertise<sensor_msgs::LaserScan>("scan", 1)); }

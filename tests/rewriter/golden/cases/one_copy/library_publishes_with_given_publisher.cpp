// Objects of a library that publish with a publisher that they are given: it keeps its class, and its topic gets shared memory.
#include <diagnostic_updater/publisher.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/LaserScan.h>

#include <memory>
#include <optional>

class Laser {
 public:
  explicit Laser(ros::NodeHandle& nh) {
    pub_ = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
    diagnosed_.reset(new diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan>(pub_));
    shared_ = boost::make_shared<diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan>>(
        nh.advertise<sensor_msgs::LaserScan>("second", 10));
    image_.emplace(nh.advertise<sensor_msgs::Image>("image", 1));
  }
  void tick() {
    auto scan = boost::make_shared<sensor_msgs::LaserScan>();
    scan->ranges.resize(720);
    diagnosed_->publish(scan);
    shared_->publish(*scan);
    pub_.publish(scan);
    image_->publish(sensor_msgs::Image());
  }

 private:
  ros::Publisher pub_;
  std::unique_ptr<diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan>> diagnosed_;
  boost::shared_ptr<diagnostic_updater::DiagnosedPublisher<sensor_msgs::LaserScan>> shared_;
  std::optional<diagnostic_updater::DiagnosedPublisher<sensor_msgs::Image>> image_;
};
//--- expected
// advertise src/node.cpp:12 sensor_msgs/LaserScan one_copy 'scan' TZC1010 it is passed to 'diagnostic_updater::DiagnosedPublisher', which is not part of the package
// advertise src/node.cpp:15 sensor_msgs/LaserScan one_copy 'second' TZC1010 nothing shows which constructor takes it
// advertise src/node.cpp:16 sensor_msgs/Image one_copy 'image' TZC1010 it is passed to 'std::optional::emplace', which is not part of the package
// publish src/node.cpp:21 sensor_msgs/LaserScan one_copy TZC1021 'diagnostic_updater::DiagnosedPublisher' publishes it
// publish src/node.cpp:22 sensor_msgs/LaserScan one_copy TZC1021 'diagnostic_updater::DiagnosedPublisher' publishes it
// publish src/node.cpp:23 sensor_msgs/LaserScan one_copy 'scan' TZC1002 it is passed to 'diagnostic_updater::DiagnosedPublisher::publish', which is not part of the package
// publish src/node.cpp:24 sensor_msgs/Image one_copy TZC1021 'diagnostic_updater::DiagnosedPublisher' publishes it
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -    pub_ = nh.advertise<sensor_msgs::LaserScan>("scan", 10);
// +    pub_ = tzc::attached<sensor_msgs::LaserScan>(nh.advertise<sensor_msgs::LaserScan>("scan", 10));
// -        nh.advertise<sensor_msgs::LaserScan>("second", 10));
// -    image_.emplace(nh.advertise<sensor_msgs::Image>("image", 1));
// +        tzc::attached<sensor_msgs::LaserScan>(nh.advertise<sensor_msgs::LaserScan>("second", 10)));
// +    image_.emplace(tzc::attached<sensor_msgs::Image>(nh.advertise<sensor_msgs::Image>("image", 1)));

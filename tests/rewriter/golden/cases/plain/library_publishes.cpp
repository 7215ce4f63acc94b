// A class of a library that advertises and publishes by itself.
#include <realtime_tools/realtime_publisher.h>
#include <sensor_msgs/Image.h>
#include <sensor_msgs/Imu.h>

class Controller {
 public:
  explicit Controller(ros::NodeHandle& nh) : images_(nh, "image", 4) {
    made_ = boost::make_shared<realtime_tools::RealtimePublisher<sensor_msgs::Image>>(nh, "made", 4);
    late_.init(nh, "late", 4);
    imu_.reset(new realtime_tools::RealtimePublisher<sensor_msgs::Imu>(nh, "imu", 4));
  }
  void update() {
    if (!images_.trylock()) return;
    images_.msg_.data.resize(10);
    images_.unlockAndPublish();
    imu_->unlockAndPublish();
  }

 private:
  realtime_tools::RealtimePublisher<sensor_msgs::Image> images_, late_;
  boost::shared_ptr<realtime_tools::RealtimePublisher<sensor_msgs::Image>> made_;
  boost::shared_ptr<realtime_tools::RealtimePublisher<sensor_msgs::Imu>> imu_;
};
//--- expected
// advertise src/node.cpp:8 sensor_msgs/Image plain 'image' TZC1021 'realtime_tools::RealtimePublisher' advertises it
// advertise src/node.cpp:9 sensor_msgs/Image plain 'made' TZC1021 'realtime_tools::RealtimePublisher' advertises it
// advertise src/node.cpp:10 sensor_msgs/Image plain 'late' TZC1021 'realtime_tools::RealtimePublisher' advertises it
// advertise src/node.cpp:11 sensor_msgs/Imu not_needed 'imu'
// publish src/node.cpp:16 sensor_msgs/Image plain TZC1021 'realtime_tools::RealtimePublisher' publishes it
// publish src/node.cpp:17 sensor_msgs/Imu not_needed

// Pointers that last start with a message where no statement can stand. The first publish binds it.
#include <memory>

#include <ros/ros.h>
#include <sensor_msgs/Image.h>

sensor_msgs::ImagePtr global(new sensor_msgs::Image);

class Node {
 public:
  explicit Node(bool choose)
      : listed_(new sensor_msgs::Image),
        made_(boost::make_shared<sensor_msgs::Image>()),
        named_(sensor_msgs::ImagePtr(new sensor_msgs::Image)),
        chosen_(choose ? new sensor_msgs::Image : nullptr) {
    timer_ = nh_.createTimer(ros::Duration(0.1), &Node::tick, this);
  }
  void tick(const ros::TimerEvent&) {
    ++count_;
    listed_->data.assign(count_, 1);
    pubs_[0].publish(*listed_);
    made_->data.assign(count_, 1);
    pubs_[0].publish(*made_);
    named_->data.assign(count_, 1);
    pubs_[0].publish(*named_);
    if (chosen_) {
      chosen_->data.assign(count_, 1);
      pubs_[0].publish(*chosen_);
    }
    equals_->data.assign(count_, 1);
    pubs_[0].publish(*equals_);
    braces_->data.assign(count_, 1);
    pubs_[0].publish(*braces_);
    owned_->data.assign(count_, 1);
    pubs_[0].publish(*owned_);
    raw_->data.assign(count_, 1);
    pubs_[0].publish(*raw_);
  }
  void lasting() {
    static sensor_msgs::ImagePtr still = boost::make_shared<sensor_msgs::Image>();
    ++count_;
    global->data.assign(count_, 1);
    pubs_[0].publish(global);
    still->data.assign(count_, 1);
    pubs_[0].publish(*still);
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher pubs_[1] = {nh_.advertise<sensor_msgs::Image>("image", 1)};
  sensor_msgs::ImagePtr listed_, made_, named_, chosen_;
  sensor_msgs::ImagePtr equals_ = boost::make_shared<sensor_msgs::Image>();
  std::shared_ptr<sensor_msgs::Image> braces_{std::make_shared<sensor_msgs::Image>()};
  std::unique_ptr<sensor_msgs::Image> owned_ = std::make_unique<sensor_msgs::Image>();
  sensor_msgs::Image* raw_ = new sensor_msgs::Image;
  ros::Timer timer_;
  int count_ = 0;
};

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  Node node(argc > 1);
  for (;;) node.lasting();
}
//--- expected
// publish src/node.cpp:21 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:23 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:28 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:33 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:35 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:37 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:43 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:45 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:50 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -sensor_msgs::ImagePtr global(new sensor_msgs::Image);
// +tzc::sensor_msgs::ImagePtr global(new tzc::sensor_msgs::Image);
// -      : listed_(new sensor_msgs::Image),
// -        made_(boost::make_shared<sensor_msgs::Image>()),
// -        named_(sensor_msgs::ImagePtr(new sensor_msgs::Image)),
// -        chosen_(choose ? new sensor_msgs::Image : nullptr) {
// +      : listed_(new tzc::sensor_msgs::Image),
// +        made_(boost::make_shared<tzc::sensor_msgs::Image>()),
// +        named_(tzc::sensor_msgs::ImagePtr(new tzc::sensor_msgs::Image)),
// +        chosen_(choose ? new tzc::sensor_msgs::Image : nullptr) {
// -    static sensor_msgs::ImagePtr still = boost::make_shared<sensor_msgs::Image>();
// +    static tzc::sensor_msgs::ImagePtr still = boost::make_shared<tzc::sensor_msgs::Image>();
// -  ros::Publisher pubs_[1] = {nh_.advertise<sensor_msgs::Image>("image", 1)};
// -  sensor_msgs::ImagePtr listed_, made_, named_, chosen_;
// -  sensor_msgs::ImagePtr equals_ = boost::make_shared<sensor_msgs::Image>();
// -  std::shared_ptr<sensor_msgs::Image> braces_{std::make_shared<sensor_msgs::Image>()};
// -  std::unique_ptr<sensor_msgs::Image> owned_ = std::make_unique<sensor_msgs::Image>();
// -  sensor_msgs::Image* raw_ = new sensor_msgs::Image;
// +  tzc::Publisher pubs_[1] = {tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)};
// +  tzc::sensor_msgs::ImagePtr listed_, made_, named_, chosen_;
// +  tzc::sensor_msgs::ImagePtr equals_ = boost::make_shared<tzc::sensor_msgs::Image>();
// +  std::shared_ptr<tzc::sensor_msgs::Image> braces_{std::make_shared<tzc::sensor_msgs::Image>()};
// +  std::unique_ptr<tzc::sensor_msgs::Image> owned_ = std::make_unique<tzc::sensor_msgs::Image>();
// +  tzc::sensor_msgs::Image* raw_ = new tzc::sensor_msgs::Image;

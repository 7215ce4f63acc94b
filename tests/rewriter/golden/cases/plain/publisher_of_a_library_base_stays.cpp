// A base class of another package has the publisher, and the call cannot be changed: it would evaluate its parts in another
// order, other instances of the template may have another class there, a macro writes it.
#include <other/library.h>

#define SEND(publisher, message) publisher.publish(message)

class Child : public other::Server {
 public:
  void order() {
    sensor_msgs::Image images[2];
    images[0].data.resize(10);
    map_pubs_[next()].publish(images[next()]);
  }
  void local_order(std::vector<sensor_msgs::Image> images) {
    for (std::size_t i = 0; i < images.size();) map_pubs_[i++].publish(images[i - 1]);
  }
  template <class Publisher>
  void any(const Publisher& publisher) {
    sensor_msgs::Image image;
    image.data.resize(10);
    publisher.publish(image);
  }
  void all() {
    any(map_pub_);
    sensor_msgs::Image image;
    image.data.resize(10);
    SEND(map_pub_, image);
  }
  void pointer_order() { shared_pub_->publish(grab()); }
  void closure_order() {
    ros::Publisher* publisher = &map_pub_;
    const auto turn = [&]() -> sensor_msgs::Image& {
      publisher = shared_pub_;
      image_.data.resize(10);
      return image_;
    };
    publisher->publish(turn());
  }

 private:
  const sensor_msgs::Image& grab() {
    shared_pub_ = &map_pub_;
    image_.data.resize(10);
    return image_;
  }
  sensor_msgs::Image image_;
  int next() { return ++next_; }
  int next_ = 0;
};
//--- expected
// publish src/node.cpp:12 sensor_msgs/Image plain TZC1017 the publisher is not one of the package, and tzc::publish would evaluate it at another time than its message
// publish src/node.cpp:15 sensor_msgs/Image plain TZC1017 the publisher is not one of the package, and tzc::publish would evaluate it at another time than its message
// publish src/node.cpp:21 sensor_msgs/Image plain TZC1017 nothing that the package advertises is given to the parameter 'publisher', and the call stands in a template
// publish src/node.cpp:27 sensor_msgs/Image plain TZC1017 the publisher is not one of the package, and the call comes from a macro
// publish src/node.cpp:29 sensor_msgs/Image plain TZC1017 the publisher is not one of the package, and tzc::publish would evaluate it at another time than its message
// publish src/node.cpp:37 sensor_msgs/Image plain TZC1017 it starts as '&map_pub_', which code outside the package builds, and tzc::publish would evaluate it at another time than its message

// Names whose type nobody wrote: of loops over classes of the package, of variables of templates, and of what instances share.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <vector>

unsigned char* kept;
sensor_msgs::Image first, second, third;

struct Step {
  sensor_msgs::Image* at;
  auto& operator*() { return *at; }
  Step& operator++() { return ++at, *this; }
  bool operator!=(const Step& other) const { return at != other.at; }
};
struct Steps {
  sensor_msgs::Image one;
  Step begin() { return {&one}; }
  Step end() { return {&one + 1}; }
};
struct Pointers {
  sensor_msgs::Image one;
  auto* begin() { return &one; }
  auto* end() { return &one + 1; }
};
struct Iterators {
  std::vector<sensor_msgs::Image> all;
  auto begin() { return all.begin(); }
  auto end() { return all.end(); }
};

template <int number>
auto* slot = &first;

template <class Any>
struct Slots {
  static inline auto* slot = &second;
};

template <class Any>
struct Shared {
  auto* slot() { return &third; }
};

class Node {
 public:
  void steps() {
    Steps images;
    images.one.data.resize(100);
    for (auto& image : images) kept = image.data.data();
    steps_pub_.publish(images.one);
    kept[0] = 1;
  }
  void pointers() {
    Pointers images;
    images.one.data.resize(100);
    for (auto& image : images) kept = image.data.data();
    pointers_pub_.publish(images.one);
    kept[0] = 1;
  }
  void iterators() {
    Iterators images;
    images.all.resize(1);
    images.all[0].data.resize(100);
    for (auto& image : images) kept = image.data.data();
    iterators_pub_.publish(images.all[0]);
    kept[0] = 1;
  }
  void templates() {
    first.data.resize(100);
    kept = slot<1>->data.data();
    first_pub_.publish(first);
    kept[0] = 1;
  }
  void static_members() {
    second.data.resize(100);
    kept = Slots<int>::slot->data.data();
    second_pub_.publish(second);
    kept[0] = 1;
  }
  void instances() {
    third.data.resize(100);
    kept = Shared<int>().slot()->data.data();
    third_pub_.publish(third);
    kept[0] = 1;
  }

 private:
  ros::NodeHandle nh_;
  ros::Publisher steps_pub_ = nh_.advertise<sensor_msgs::Image>("steps", 1);
  ros::Publisher pointers_pub_ = nh_.advertise<sensor_msgs::Image>("pointers", 1);
  ros::Publisher iterators_pub_ = nh_.advertise<sensor_msgs::Image>("iterators", 1);
  ros::Publisher first_pub_ = nh_.advertise<sensor_msgs::Image>("first", 1);
  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("second", 1);
  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("third", 1);
};
//--- expected
// publish src/node.cpp:51 sensor_msgs/Image one_copy 'steps' TZC1003 a pointer into its data is kept in 'kept'
// publish src/node.cpp:58 sensor_msgs/Image one_copy 'pointers' TZC1003 a pointer into its data is kept in 'kept'
// publish src/node.cpp:66 sensor_msgs/Image one_copy 'iterators' TZC1003 a pointer into its data is kept in 'kept'
// publish src/node.cpp:72 sensor_msgs/Image one_copy 'first' TZC1001 a variable of a template starts with it
// publish src/node.cpp:78 sensor_msgs/Image one_copy 'second' TZC1001 a variable of a template starts with it
// publish src/node.cpp:84 sensor_msgs/Image one_copy 'third' TZC1003 a pointer into its data is kept in 'kept'
// advertise src/node.cpp:90 sensor_msgs/Image one_copy 'steps'
// advertise src/node.cpp:91 sensor_msgs/Image one_copy 'pointers'
// advertise src/node.cpp:92 sensor_msgs/Image one_copy 'iterators'
// advertise src/node.cpp:93 sensor_msgs/Image one_copy 'first'
// advertise src/node.cpp:94 sensor_msgs/Image one_copy 'second'
// advertise src/node.cpp:95 sensor_msgs/Image one_copy 'third'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -  ros::Publisher steps_pub_ = nh_.advertise<sensor_msgs::Image>("steps", 1);
// -  ros::Publisher pointers_pub_ = nh_.advertise<sensor_msgs::Image>("pointers", 1);
// -  ros::Publisher iterators_pub_ = nh_.advertise<sensor_msgs::Image>("iterators", 1);
// -  ros::Publisher first_pub_ = nh_.advertise<sensor_msgs::Image>("first", 1);
// -  ros::Publisher second_pub_ = nh_.advertise<sensor_msgs::Image>("second", 1);
// -  ros::Publisher third_pub_ = nh_.advertise<sensor_msgs::Image>("third", 1);
// +  tzc::Publisher steps_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "steps", 1);
// +  tzc::Publisher pointers_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "pointers", 1);
// +  tzc::Publisher iterators_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "iterators", 1);
// +  tzc::Publisher first_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "first", 1);
// +  tzc::Publisher second_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "second", 1);
// +  tzc::Publisher third_pub_ = tzc::advertise<sensor_msgs::Image>(nh_, "third", 1);

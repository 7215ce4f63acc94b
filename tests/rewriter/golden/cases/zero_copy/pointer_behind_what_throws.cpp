// A pointer to the publisher may be null where an exception keeps it from being followed: memory is the node's.
#include <bitset>
#include <filesystem>
#include <memory>
#include <new>
#include <ros/ros.h>
#include <sensor_msgs/Image.h>
#include <sstream>
#include <typeinfo>
#include <vector>

struct Base {
  virtual ~Base() {}
};
struct Derived : Base {
  int width = 0;
};
struct Checked {
  explicit Checked(Base& base) : derived(dynamic_cast<Derived&>(base)) {}
  Derived& derived;
};

class Node {
 public:
  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
  void select() { current_ = &pub_; }

  void by_erase(std::string text) {
    sensor_msgs::Image image;
    image.data.resize(101);
    try { text.erase(4); current_->publish(image); } catch (const std::out_of_range&) {}
  }
  void by_time(double seconds) {
    sensor_msgs::Image image;
    image.data.resize(102);
    try { image.header.stamp = ros::Time(seconds); current_->publish(image); } catch (const std::runtime_error&) {}
  }
  void by_time_computed(int n) {
    sensor_msgs::Image image;
    image.data.resize(103);
    try { image.header.stamp = ros::Time::now() - ros::Duration(n * 1e9); current_->publish(image); } catch (const std::runtime_error&) {}
  }
  void by_cast(Base& base) {
    sensor_msgs::Image image;
    image.data.resize(104);
    try { image.width = dynamic_cast<Derived&>(base).width; current_->publish(image); } catch (const std::bad_cast&) {}
  }
  void by_typeid(Base* base) {
    sensor_msgs::Image image;
    image.data.resize(105);
    try { image.encoding = typeid(*base).name(); current_->publish(image); } catch (const std::bad_typeid&) {}
  }
  void by_array(int n) {
    sensor_msgs::Image image;
    image.data.resize(106);
    try { std::unique_ptr<int[]> numbers(new int[n]); current_->publish(image); } catch (const std::bad_alloc&) {}
  }
  void by_size(int n) {
    sensor_msgs::Image image;
    try { image.data.resize(n); current_->publish(image); } catch (const std::length_error&) {}
  }
  void by_difference(std::size_t n) {
    sensor_msgs::Image image;
    try { image.data.resize(n - 1); current_->publish(image); } catch (const std::length_error&) {}
  }
  void by_text(int n) {
    sensor_msgs::Image image;
    image.data.resize(107);
    try { std::string text(n, ' '); current_->publish(image); } catch (const std::length_error&) {}
  }
  void by_null_text(const char* text) {
    sensor_msgs::Image image;
    image.data.resize(108);
    try { std::string copy(text); current_->publish(image); } catch (const std::logic_error&) {}
  }
  void by_bits(int n) {
    sensor_msgs::Image image;
    image.data.resize(109);
    try { std::bitset<8> bits; bits.set(n); current_->publish(image); } catch (const std::out_of_range&) {}
  }
  void by_weak(std::weak_ptr<int> weak) {
    sensor_msgs::Image image;
    image.data.resize(110);
    try { std::shared_ptr<int> strong(weak); current_->publish(image); } catch (const std::bad_weak_ptr&) {}
  }
  void by_file(const std::string& path) {
    sensor_msgs::Image image;
    image.data.resize(111);
    try { image.width = std::filesystem::file_size(path); current_->publish(image); } catch (const std::filesystem::filesystem_error&) {}
  }
  void by_stream(std::istream& in) {
    sensor_msgs::Image image;
    image.data.resize(112);
    in.exceptions(std::ios::failbit);
    try { in >> image.width; current_->publish(image); } catch (const std::ios::failure&) {}
  }
  void by_own_stream(int n) {
    sensor_msgs::Image image;
    image.data.resize(113);
    std::ostringstream text;
    text.exceptions(std::ios::failbit);
    try { text << n; current_->publish(image); } catch (const std::ios::failure&) {}
  }
  void by_initializer(Base& base) {
    sensor_msgs::Image image;
    image.data.resize(114);
    try { Checked checked(base); current_->publish(image); } catch (const std::bad_cast&) {}
  }
  void by_comparison(std::vector<int> values) {
    sensor_msgs::Image image;
    image.data.resize(115);
    try { std::sort(values.begin(), values.end(), less); current_->publish(image); } catch (int) {}
  }
  void by_callback() {
    sensor_msgs::Image image;
    image.data.resize(116);
    try { ros::spinOnce(); current_->publish(image); } catch (const std::exception&) {}
  }

 private:
  static bool less(int a, int b) {
    if (a < 0) throw a;
    return a < b;
  }
  ros::NodeHandle nh_;
  ros::Publisher pub_;
  ros::Publisher* current_ = nullptr;
};
//--- expected
// advertise src/node.cpp:25 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:31 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:36 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:41 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:46 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:51 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:56 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:60 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:64 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:69 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:74 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:79 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:84 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:89 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:95 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:102 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:107 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:112 sensor_msgs/Image zero_copy 'image'
// publish src/node.cpp:117 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -  Node() : pub_(nh_.advertise<sensor_msgs::Image>("image", 1)) {}
// +  Node() : pub_(tzc::advertise<tzc::sensor_msgs::Image>(nh_, "image", 1)) {}
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -    sensor_msgs::Image image;
// +    tzc::sensor_msgs::Image image;
// +    pub_.allocate(image);
// -  ros::Publisher pub_;
// -  ros::Publisher* current_ = nullptr;
// +  tzc::Publisher pub_;
// +  tzc::Publisher* current_ = nullptr;

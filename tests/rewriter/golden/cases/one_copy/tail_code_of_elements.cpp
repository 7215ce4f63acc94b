// A pointer into the message escaped. Behind the publish nothing of the package is called, but a library runs its code by the
// type of what it handles, or the compiler does: the write comes before the message ends, and after subscribers have it.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <array>
#include <iostream>
#include <utility>
#include <vector>

static ros::Publisher pub;
static uint8_t* raw;
static void write() {
  *raw = 1;
}

struct Ends {
  ~Ends() { write(); }
};
struct Starts {
  Starts() { write(); }
};
struct Copied {
  Copied() {}
  Copied(const Copied&) { write(); }
  Copied& operator=(const Copied&) {
    write();
    return *this;
  }
};
struct Compared {
  int number;
};
static bool operator==(const Compared&, const Compared&) {
  write();
  return true;
}
template <class T>
struct Allocator {
  using value_type = T;
  Allocator() = default;
  template <class U>
  Allocator(const Allocator<U>&) {}
  T* allocate(size_t n) {
    write();
    return std::allocator<T>().allocate(n);
  }
  void deallocate(T* p, size_t n) { std::allocator<T>().deallocate(p, n); }
};
template <class A, class B>
bool operator==(const Allocator<A>&, const Allocator<B>&) {
  return true;
}
template <class A, class B>
bool operator!=(const Allocator<A>&, const Allocator<B>&) {
  return false;
}
struct Buffer : std::streambuf {
  int overflow(int c) override {
    write();
    return c;
  }
};
static Buffer buffer;
static std::vector<Copied> some(1), others(1);
static std::vector<Compared> first(1), second(1);

void element_ends() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::vector<Ends> ends(1);
}
void earlier_element_ends() {
  sensor_msgs::Image image;
  std::array<Ends, 1> ends;
  std::pair<int, Ends> pair;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
}
void element_starts() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::vector<Starts> starts(1);
}
void element_is_copied() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::vector<Copied> copies(some);
}
void element_is_assigned() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  some = others;
}
void element_is_compared() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  const bool equal = first == second;
}
void own_allocator() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::vector<int, Allocator<int>> numbers(1);
}
void own_stream_buffer() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::cout << 1;
}

void nothing() {
  sensor_msgs::Image image;
  image.data.resize(100);
  raw = image.data.data();
  pub.publish(image);
  std::vector<int> numbers(1);
}

int main(int argc, char** argv) {
  ros::init(argc, argv, "node");
  ros::NodeHandle nh;
  std::cout.rdbuf(&buffer);
  pub = nh.advertise<sensor_msgs::Image>("image", 1);
  element_ends();
}
//--- expected
// publish src/node.cpp:72 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:81 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:87 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:94 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:101 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:108 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:115 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:122 sensor_msgs/Image one_copy 'image' TZC1003 a pointer into its data is kept in 'raw'
// publish src/node.cpp:130 sensor_msgs/Image zero_copy 'image'
// advertise src/node.cpp:138 sensor_msgs/Image zero_copy 'image'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// +#include <tzc/sensor_msgs/Image.h>
// -static ros::Publisher pub;
// +static tzc::Publisher pub;
// -  sensor_msgs::Image image;
// +  tzc::sensor_msgs::Image image;
// +  pub.allocate(image);
// -  pub = nh.advertise<sensor_msgs::Image>("image", 1);
// +  pub = tzc::advertise<tzc::sensor_msgs::Image>(nh, "image", 1);

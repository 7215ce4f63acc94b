// Code of the package that a library, or the language, finds by the type of what it handles.
#include <ros/ros.h>
#include <sensor_msgs/Image.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

ros::Publisher array_pub, made_pub, ended_pub, printed_pub, taken_pub, swapped_pub, given_pub, compared_pub, based_pub, converted_pub;
sensor_msgs::Image array, made, ended, printed, taken, swapped, given, compared, based, converted;

struct Copied {
  Copied() = default;
  Copied(const Copied&) { array_pub.publish(array); }
};
struct Made {
  void* operator new(size_t size) { return made_pub.publish(made), ::operator new(size); }
  void operator delete(void* memory) { ended_pub.publish(ended), ::operator delete(memory); }
};
struct Printed {};
std::ostream& operator<<(std::ostream& stream, const Printed&) { return printed_pub.publish(printed), stream; }
struct Taken {
  template <int index>
  int get() {
    return taken_pub.publish(taken), index;
  }
};
namespace std {
template <>
struct tuple_size<Taken> : integral_constant<size_t, 1> {};
template <>
struct tuple_element<0, Taken> {
  using type = int;
};
}  // namespace std
struct Swapped {};
void swap(Swapped&, Swapped&) { swapped_pub.publish(swapped); }
template <class T>
struct Given {
  using value_type = T;
  T* allocate(size_t count) { return given_pub.publish(given), static_cast<T*>(::operator new(count * sizeof(T))); }
  void deallocate(T* memory, size_t) { ::operator delete(memory); }
};
enum class Compared { one };
bool operator<(Compared, Compared) { return compared_pub.publish(compared), false; }
struct Base {};
bool operator<(const Base&, const Base&) { return based_pub.publish(based), false; }
struct Derived : Base {};
struct Converted {
  operator int() const { return converted_pub.publish(converted), 1; }
};

#define HELD(message, publishes)       \
  {                                    \
    message.data.resize(100);          \
    auto* elements = &message.data[0]; \
    publishes;                         \
    elements[0] = 1;                   \
  }

void run() {
  std::array<Copied, 1> copies;
  HELD(array, const auto copy = copies);
  Made* object = nullptr;
  HELD(made, object = new Made);
  HELD(ended, delete object);
  std::ostringstream text;
  Printed words[1];
  HELD(printed, std::copy(words, words + 1, std::ostream_iterator<Printed>(text)));
  HELD(taken, auto [number] = Taken());
  Swapped pair[2];
  HELD(swapped, std::iter_swap(pair, pair + 1));
  std::vector<int, Given<int>> numbers;
  HELD(given, numbers.push_back(1));
  std::set<Compared> set{Compared::one};
  HELD(compared, set.insert(Compared::one));
  Derived derived[2];
  HELD(based, std::sort(derived, derived + 2));
  Converted from[1];
  int to[1];
  HELD(converted, std::copy(from, from + 1, to));
}

void advertise(ros::NodeHandle& nh) {
  array_pub = nh.advertise<sensor_msgs::Image>("array", 1);
  made_pub = nh.advertise<sensor_msgs::Image>("made", 1);
  ended_pub = nh.advertise<sensor_msgs::Image>("ended", 1);
  printed_pub = nh.advertise<sensor_msgs::Image>("printed", 1);
  taken_pub = nh.advertise<sensor_msgs::Image>("taken", 1);
  swapped_pub = nh.advertise<sensor_msgs::Image>("swapped", 1);
  given_pub = nh.advertise<sensor_msgs::Image>("given", 1);
  compared_pub = nh.advertise<sensor_msgs::Image>("compared", 1);
  based_pub = nh.advertise<sensor_msgs::Image>("based", 1);
  converted_pub = nh.advertise<sensor_msgs::Image>("converted", 1);
}
//--- expected
// publish src/node.cpp:18 sensor_msgs/Image one_copy 'array' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:21 sensor_msgs/Image one_copy 'made' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:22 sensor_msgs/Image one_copy 'ended' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:25 sensor_msgs/Image one_copy 'printed' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:29 sensor_msgs/Image one_copy 'taken' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:41 sensor_msgs/Image one_copy 'swapped' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:45 sensor_msgs/Image one_copy 'given' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:49 sensor_msgs/Image one_copy 'compared' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:51 sensor_msgs/Image one_copy 'based' TZC1003 'elements' points into its data and is used after the message may have been published
// publish src/node.cpp:54 sensor_msgs/Image one_copy 'converted' TZC1003 'elements' points into its data and is used after the message may have been published
// advertise src/node.cpp:89 sensor_msgs/Image one_copy 'array'
// advertise src/node.cpp:90 sensor_msgs/Image one_copy 'made'
// advertise src/node.cpp:91 sensor_msgs/Image one_copy 'ended'
// advertise src/node.cpp:92 sensor_msgs/Image one_copy 'printed'
// advertise src/node.cpp:93 sensor_msgs/Image one_copy 'taken'
// advertise src/node.cpp:94 sensor_msgs/Image one_copy 'swapped'
// advertise src/node.cpp:95 sensor_msgs/Image one_copy 'given'
// advertise src/node.cpp:96 sensor_msgs/Image one_copy 'compared'
// advertise src/node.cpp:97 sensor_msgs/Image one_copy 'based'
// advertise src/node.cpp:98 sensor_msgs/Image one_copy 'converted'
//
// +++ src/node.cpp
// +#include <tzc/ros.h>
// -ros::Publisher array_pub, made_pub, ended_pub, printed_pub, taken_pub, swapped_pub, given_pub, compared_pub, based_pub, converted_pub;
// +tzc::Publisher array_pub, made_pub, ended_pub, printed_pub, taken_pub, swapped_pub, given_pub, compared_pub, based_pub, converted_pub;
// -  array_pub = nh.advertise<sensor_msgs::Image>("array", 1);
// -  made_pub = nh.advertise<sensor_msgs::Image>("made", 1);
// -  ended_pub = nh.advertise<sensor_msgs::Image>("ended", 1);
// -  printed_pub = nh.advertise<sensor_msgs::Image>("printed", 1);
// -  taken_pub = nh.advertise<sensor_msgs::Image>("taken", 1);
// -  swapped_pub = nh.advertise<sensor_msgs::Image>("swapped", 1);
// -  given_pub = nh.advertise<sensor_msgs::Image>("given", 1);
// -  compared_pub = nh.advertise<sensor_msgs::Image>("compared", 1);
// -  based_pub = nh.advertise<sensor_msgs::Image>("based", 1);
// -  converted_pub = nh.advertise<sensor_msgs::Image>("converted", 1);
// +  array_pub = tzc::advertise<sensor_msgs::Image>(nh, "array", 1);
// +  made_pub = tzc::advertise<sensor_msgs::Image>(nh, "made", 1);
// +  ended_pub = tzc::advertise<sensor_msgs::Image>(nh, "ended", 1);
// +  printed_pub = tzc::advertise<sensor_msgs::Image>(nh, "printed", 1);
// +  taken_pub = tzc::advertise<sensor_msgs::Image>(nh, "taken", 1);
// +  swapped_pub = tzc::advertise<sensor_msgs::Image>(nh, "swapped", 1);
// +  given_pub = tzc::advertise<sensor_msgs::Image>(nh, "given", 1);
// +  compared_pub = tzc::advertise<sensor_msgs::Image>(nh, "compared", 1);
// +  based_pub = tzc::advertise<sensor_msgs::Image>(nh, "based", 1);
// +  converted_pub = tzc::advertise<sensor_msgs::Image>(nh, "converted", 1);

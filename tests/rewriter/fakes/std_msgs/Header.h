// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <boost/core.h>
#include <cstdint>
#include <iostream>
#include <string>
#include <vector>
namespace ros {
struct Duration {
  double sec = 0;
  explicit Duration(double s = 0) : sec(s) {}
};
struct Time {
  double sec = 0;
  Time() = default;
  explicit Time(double s) : sec(s) {}
  static Time now() { return {}; }
  double toSec() const { return sec; }
  bool operator<(const Time& other) const { return sec < other.sec; }
  Time operator-(const Duration& other) const { return Time(sec - other.sec); }
};
}  // namespace ros
#define FAKE_MESSAGE(package, name)                              \
  namespace package {                                            \
  typedef name##_<std::allocator<void>> name;                    \
  typedef boost::shared_ptr<name> name##Ptr;                     \
  typedef boost::shared_ptr<name const> name##ConstPtr;          \
  template <class A>                                             \
  std::ostream& operator<<(std::ostream& s, const name##_<A>&) { \
    return s;                                                    \
  }                                                              \
  }
#define FAKE_MEMBERS(name)             \
  typedef boost::shared_ptr<name> Ptr; \
  typedef boost::shared_ptr<name const> ConstPtr;
namespace std_msgs {
template <class A>
struct Header_ {
  uint32_t seq = 0;
  ros::Time stamp;
  std::string frame_id;
  FAKE_MEMBERS(Header_)
};
}  // namespace std_msgs
FAKE_MESSAGE(std_msgs, Header)

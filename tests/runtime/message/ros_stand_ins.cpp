// SPDX-License-Identifier: BSD-3-Clause
/// The few functions of ROS's libraries that message headers call, for a machine that has ROS's headers alone: the
/// message tests are cross-compiled with it (scripts/test.d/full/2-arm64).
#include <ros/duration.h>
#include <ros/impl/duration.h>
#include <ros/impl/time.h>
#include <ros/serialization.h>
#include <ros/time.h>

#include <ostream>

namespace ros {

template bool TimeBase<Time, Duration>::operator==(const Time&) const;
template bool DurationBase<Duration>::operator==(const Duration&) const;

std::ostream& operator<<(std::ostream& out, const Time& time) {
  return out << time.sec << "s " << time.nsec << "ns";
}
std::ostream& operator<<(std::ostream& out, const Duration& duration) {
  return out << duration.sec << "s " << duration.nsec << "ns";
}

namespace serialization {
void throwStreamOverrun() {
  throw StreamOverrunException("stream overrun");
}
}  // namespace serialization
}  // namespace ros

// SPDX-License-Identifier: BSD-3-Clause
// Messages that are made of others; TZC has no headers for them.
#pragma once
#include <sensor_msgs/CameraInfo.h>
namespace vendor_msgs {
template <class A>
struct Rig_ {
  sensor_msgs::CameraInfo left, right;
  FAKE_MEMBERS(Rig_)
};
typedef Rig_<std::allocator<void>> Rig;
template <class A>
struct FiftyRigs_ {
  boost::array<Rig, 50> rigs;
  FAKE_MEMBERS(FiftyRigs_)
};
template <class A>
struct ManyRigs_ {
  std::vector<Rig> rigs;
  FAKE_MEMBERS(ManyRigs_)
};
}  // namespace vendor_msgs
FAKE_MESSAGE(vendor_msgs, FiftyRigs)
FAKE_MESSAGE(vendor_msgs, ManyRigs)

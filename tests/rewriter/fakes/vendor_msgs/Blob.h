// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace vendor_msgs {
template <class A>
struct Blob_ {
  std_msgs::Header header;
  std::string format;
  std::vector<uint8_t> data;
  FAKE_MEMBERS(Blob_)
};
}  // namespace vendor_msgs
FAKE_MESSAGE(vendor_msgs, Blob)

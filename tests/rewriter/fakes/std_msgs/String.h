// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <std_msgs/Header.h>
namespace std_msgs {
template <class A>
struct String_ {
  std::string data;
  FAKE_MEMBERS(String_)
};
}  // namespace std_msgs
FAKE_MESSAGE(std_msgs, String)

// SPDX-License-Identifier: BSD-3-Clause
#pragma once
#include <cstdint>
namespace ros {
namespace serialization {
struct OStream {
  OStream(uint8_t*, uint32_t) {}
};
template <class M>
uint32_t serializationLength(const M&) {
  return 0;
}
template <class Stream, class M>
void serialize(Stream&, const M&) {}
}  // namespace serialization
namespace message_traits {
template <class M>
const char* md5sum(const M&) {
  return "";
}
}  // namespace message_traits
}  // namespace ros

// SPDX-License-Identifier: BSD-3-Clause
#include "roscpp/traces/tcpros_message.h"

namespace tzc {
namespace detail {
namespace {

/// FNV-1a, which every build of every process computes alike.
class Hash {
 public:
  void add(const std::string& text) {
    for (const char c : text) add_byte(static_cast<unsigned char>(c));
    add_byte(0);
  }
  void add(std::uint32_t number) {
    for (int shift = 0; shift < 32; shift += 8) add_byte(static_cast<unsigned char>(number >> shift));
  }
  std::uint64_t value() const { return value_; }

 private:
  void add_byte(unsigned char byte) { value_ = (value_ ^ byte) * 0x100000001b3; }
  std::uint64_t value_ = 0xcbf29ce484222325;
};

}  // namespace

std::uint64_t trace_id(const TcprosMessage& message) {
  if (message.stamp_s == 0 && message.stamp_ns == 0) return 0;
  Hash hash;
  hash.add(message.topic);
  hash.add(message.publisher);
  hash.add(message.subscriber);
  hash.add(message.stamp_s);
  hash.add(message.stamp_ns);
  return hash.value();
}

}  // namespace detail
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
// A small language for messages and recordings, so that a case is a few lines.
#pragma once

#include <cstring>
#include <string>
#include <utility>
#include <vector>

#include "engine/comparison.h"

namespace tzc::compare::testing {

inline const char* const header_section =
    "================================================================================\n"
    "MSG: std_msgs/Header\n"
    "# Standard metadata\nuint32 seq\n#stamp\ntime stamp\nstring frame_id\n";

/// A message's bytes, written field by field.
class Wire {
 public:
  template <class T>
  Wire& put(T value) {
    const auto* const bytes = reinterpret_cast<const std::uint8_t*>(&value);
    bytes_.insert(bytes_.end(), bytes, bytes + sizeof value);
    return *this;
  }
  Wire& text(const std::string& value) {
    put(static_cast<std::uint32_t>(value.size()));
    bytes_.insert(bytes_.end(), value.begin(), value.end());
    return *this;
  }
  Wire& header(std::uint32_t seq, std::uint32_t seconds, const std::string& frame = "camera") {
    return put(seq).put(seconds).put(std::uint32_t{0}).text(frame);
  }
  Wire& bytes(const std::vector<std::uint8_t>& values) {
    put(static_cast<std::uint32_t>(values.size()));
    bytes_.insert(bytes_.end(), values.begin(), values.end());
    return *this;
  }
  operator Bytes() const { return bytes_; }  // NOLINT(google-explicit-constructor): it is those bytes

 private:
  Bytes bytes_;
};

inline const std::string picture_definition =
    std::string("Header header\nstring encoding\nuint8[] data\n") + header_section;

/// A message of picture_definition.
inline Bytes picture(std::uint32_t seq, std::uint32_t seconds, const std::vector<std::uint8_t>& data) {
  return Wire().header(seq, seconds).text("mono8").bytes(data);
}

/// A recorded stream of these messages, as the tool makes it of a bag.
inline Stream stream(const std::string& topic, const std::vector<Bytes>& messages,
                     const std::string& datatype = "test/Picture",
                     const std::string& definition = picture_definition) {
  Stream result{topic, "/node", datatype, "md5 of " + datatype, definition, {}, {}, 0};
  const Field root = parse_definition(datatype, definition).value_or(Field());
  const Masks masks(root, filter_for(root, {true, {}}));
  for (Bytes message : messages) {
    const auto header = header_stamp(root, message);
    const std::size_t size = message.size();
    masks.apply(message);
    result.messages.push_back({0, header, digest_of(message), size});
  }
  result.read = [messages](std::size_t index) { return messages[index]; };
  return result;
}

/// Messages whose stamps are those of the input: 1 s, 2 s, ...
inline std::vector<Bytes> stamped(const std::vector<int>& numbers) {
  std::vector<Bytes> messages;
  for (const int n : numbers)
    messages.push_back(picture(0, static_cast<std::uint32_t>(n), {static_cast<std::uint8_t>(n)}));
  return messages;
}
/// Messages whose stamps differ from run to run.
inline std::vector<Bytes> unstamped(const std::vector<int>& numbers, std::uint32_t run) {
  std::vector<Bytes> messages;
  for (const int n : numbers)
    messages.push_back(picture(static_cast<std::uint32_t>(n), 1000 * run + static_cast<std::uint32_t>(n),
                               {static_cast<std::uint8_t>(n)}));
  return messages;
}

}  // namespace tzc::compare::testing

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tzc::compare {

enum class Kind {
  boolean,
  int8,
  uint8,
  int16,
  uint16,
  int32,
  uint32,
  int64,
  uint64,
  float32,
  float64,
  string,
  time,
  duration,
  message
};

/// A field of a message as the definition text declares it, its message type expanded.
struct Field {
  enum class Count { one, fixed, variable };

  std::string
      path;  ///< from the message's root, without indices: "markers[].points[].x"; "" for the root itself
  Kind kind = Kind::message;
  Count count = Count::one;
  std::uint32_t fixed_count = 1;       ///< elements of a fixed array
  std::vector<Field> children;         ///< of a message
  std::optional<std::size_t> element;  ///< bytes of one element on the wire when every element has the same
  bool is_header = false;              ///< a std_msgs/Header, by its name and its fields
};

/// Reads a message's full definition text (the connection header's `message_definition`): the type's own
/// fields, then a section "MSG: package/Type" for each type that it uses. Null when the text lacks a type or
/// cannot be read.
/// @param datatype "package/Type", which unqualified names are looked up in
std::optional<Field> parse_definition(const std::string& datatype, const std::string& text);

}  // namespace tzc::compare

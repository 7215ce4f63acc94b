// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "wire/cursor.h"
#include "wire/definition.h"

namespace tzc::compare {

/// Is this field left out of the comparison?
using FieldFilter = std::function<bool(const std::string& path)>;

struct Range {
  std::size_t offset, size;
};

struct HeaderStamp {
  std::uint32_t seq = 0;
  std::int64_t nanoseconds = 0;  ///< 0: never set
};

/// Where the fields of one message type lie that a comparison leaves out. Header.seq, at any depth, is always
/// one of them: it counts what was sent. Immutable, so thread-safe.
class Masks {
 public:
  /// @param definition expanded definition of the message type
  /// @param left_out further fields to leave out, by path without indices ("header.stamp",
  /// "poses[].header.stamp")
  Masks(const Field& definition, const FieldFilter& left_out);
  ~Masks();
  Masks(Masks&&) noexcept;

  /// The ranges of one message, ascending. Null when the bytes do not fit the definition.
  std::optional<std::vector<Range>> ranges(const Bytes& message) const;
  /// Sets those ranges to zero; strings and arrays that are left out lose their content and keep their
  /// length. False: nothing was changed, the bytes do not fit the definition.
  bool apply(Bytes& message) const;

 private:
  struct Node;
  static Node build(const Field& field, const FieldFilter& left_out, bool inside_header);
  static bool collect(const Node& node, Cursor& cursor, std::vector<Range>& ranges);
  static bool collect_elements(const Node& node, std::uint32_t count, Cursor& cursor,
                               std::vector<Range>& ranges);
  static bool collect_element(const Node& node, Cursor& cursor, std::vector<Range>& ranges);

  std::unique_ptr<Node> root_;
};

/// Is this path a header's stamp?
bool is_header_stamp(const Field& definition, const std::string& path);

/// The first header of a message whose first field it is; null for other messages.
std::optional<HeaderStamp> header_stamp(const Field& definition, const Bytes& message);

}  // namespace tzc::compare

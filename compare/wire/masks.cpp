// SPDX-License-Identifier: BSD-3-Clause
#include "wire/masks.h"

#include <algorithm>

namespace tzc::compare {

struct Masks::Node {
  Kind kind;
  Field::Count count;
  std::uint32_t fixed_count;
  std::optional<std::size_t> element;
  bool is_masked = false;
  bool has_mask = false;  ///< it, or a field inside it, is masked
  std::vector<Node> children;
};

Masks::Masks(const Field& definition, const FieldFilter& left_out)
    : root_(std::make_unique<Node>(build(definition, left_out, false))) {}
Masks::~Masks() = default;
Masks::Masks(Masks&&) noexcept = default;

Masks::Node Masks::build(const Field& field, const FieldFilter& left_out, bool inside_header) {
  Node node{field.kind, field.count, field.fixed_count, field.element, false, false, {}};
  const bool is_seq = inside_header && field.kind == Kind::uint32;
  node.is_masked = !field.path.empty() && (is_seq || left_out(field.path));
  node.has_mask = node.is_masked;
  const FieldFilter all = [](const std::string&) { return true; };
  for (const Field& child : field.children) {
    node.children.push_back(build(child, node.is_masked ? all : left_out, field.is_header));
    node.has_mask = node.has_mask || node.children.back().has_mask;
  }
  return node;
}

bool Masks::collect(const Node& node, Cursor& cursor, std::vector<Range>& ranges) {
  std::uint32_t count = node.fixed_count;
  if (node.count == Field::Count::variable) {
    const std::optional<std::uint32_t> length = cursor.read_uint32();
    if (!length) return false;
    count = *length;
  }
  return collect_elements(node, count, cursor, ranges);
}

bool Masks::collect_elements(const Node& node, std::uint32_t count, Cursor& cursor,
                             std::vector<Range>& ranges) {
  if (node.element && (node.is_masked || !node.has_mask)) {
    const std::size_t offset = cursor.offset();
    if (!cursor.skip(count, *node.element)) return false;
    if (node.is_masked) ranges.push_back({offset, cursor.offset() - offset});
    return true;
  }
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!collect_element(node, cursor, ranges)) return false;
  }
  return true;
}

bool Masks::collect_element(const Node& node, Cursor& cursor, std::vector<Range>& ranges) {
  if (node.kind == Kind::string) {
    const std::optional<std::uint32_t> length = cursor.read_uint32();
    if (!length) return false;
    if (node.is_masked) ranges.push_back({cursor.offset(), *length});
    return cursor.skip(*length);
  }
  return std::all_of(node.children.begin(), node.children.end(),
                     [&](const Node& child) { return collect(child, cursor, ranges); });
}

std::optional<std::vector<Range>> Masks::ranges(const Bytes& message) const {
  Cursor cursor(message);
  std::vector<Range> found;
  if (!collect(*root_, cursor, found) || cursor.left() != 0) return std::nullopt;
  return found;
}

bool Masks::apply(Bytes& message) const {
  const std::optional<std::vector<Range>> masked = ranges(message);
  if (!masked) return false;
  for (const Range& range : *masked) std::memset(message.data() + range.offset, 0, range.size);
  return true;
}

bool is_header_stamp(const Field& definition, const std::string& path) {
  return std::any_of(definition.children.begin(), definition.children.end(), [&](const Field& child) {
    if (definition.is_header) return child.kind == Kind::time && child.path == path;
    return is_header_stamp(child, path);
  });
}

std::optional<HeaderStamp> header_stamp(const Field& definition, const Bytes& message) {
  const bool leads = !definition.children.empty() && definition.children.front().is_header &&
                     definition.children.front().count == Field::Count::one;
  Cursor cursor(message);
  const auto seq = cursor.read_uint32(), seconds = cursor.read_uint32(), nanoseconds = cursor.read_uint32();
  if ((!leads && !definition.is_header) || !nanoseconds) return std::nullopt;
  return HeaderStamp{*seq, std::int64_t{*seconds} * 1'000'000'000 + *nanoseconds};
}

}  // namespace tzc::compare

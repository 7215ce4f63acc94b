// SPDX-License-Identifier: BSD-3-Clause
#include "wire/field_difference.h"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "wire/value_text.h"

namespace tzc::compare {
namespace {

/// One element of a field in one message: its bytes, a string's without the length in front.
struct Element {
  std::size_t offset = 0;
  const std::uint8_t* bytes = nullptr;
  std::size_t size = 0;
};

std::size_t common_prefix(const std::uint8_t* first, const std::uint8_t* second, std::size_t size) {
  return static_cast<std::size_t>(std::mismatch(first, first + size, second).first - first);
}

/// Walks both messages in step.
class Comparison {
 public:
  Comparison(const Bytes& first, const Bytes& second)
      : first_bytes_(first), second_bytes_(second), first_(first), second_(second) {}

  std::vector<FieldDifference> run(const Field& root) {
    if (!elements(root, 1, 1, "") || first_.left() != 0 || second_.left() != 0) compare_rest();
    // Where bytes do not fit, a cursor may have passed the difference.
    if (found_.empty()) {
      first_ = Cursor(first_bytes_);
      second_ = Cursor(second_bytes_);
      compare_rest();
    }
    return std::move(found_);
  }

 private:
  // Each returns false where a message's bytes do not fit the definition; both cursors stay near that place.

  bool field(const Field& field, const std::string& where) {
    std::uint32_t first_count = field.fixed_count, second_count = field.fixed_count;
    if (field.count == Field::Count::variable && !read_counts(field, where, first_count, second_count))
      return false;
    return elements(field, first_count, second_count, where);
  }

  bool read_counts(const Field& field, const std::string& where, std::uint32_t& first,
                   std::uint32_t& second) {
    const std::size_t first_offset = first_.offset(), second_offset = second_.offset();
    const auto first_count = first_.read_uint32(), second_count = second_.read_uint32();
    if (!first_count || !second_count) return false;
    first = *first_count;
    second = *second_count;
    if (first != second)
      add({field.path, where, first_offset, second_offset, fmt::format("{} elements", first),
           fmt::format("{} elements", second)});
    return true;
  }

  /// All elements of a field; those that only one message has are passed over.
  bool elements(const Field& field, std::uint32_t first_count, std::uint32_t second_count,
                const std::string& where) {
    const std::uint32_t common = std::min(first_count, second_count);
    if (field.element && field.kind != Kind::message) {
      return compare_block(field, common, where) && first_.skip(first_count - common, *field.element) &&
             second_.skip(second_count - common, *field.element);
    }
    std::uint32_t start = 0;
    if (field.element && field.count != Field::Count::one) start = skip_equal(*field.element, common);
    for (std::uint32_t i = start; i < common; ++i) {
      if (!element(field, field.count == Field::Count::one ? where : fmt::format("{}[{}]", where, i)))
        return false;
    }
    return pass_over(field, first_count - common, first_) && pass_over(field, second_count - common, second_);
  }

  /// Messages of a fixed size: the first `count` that are equal need no look at their fields.
  std::uint32_t skip_equal(std::size_t size, std::uint32_t count) {
    const std::size_t bytes = std::min({first_.left(), second_.left(), size * count});
    const std::size_t equal = size == 0 ? count : common_prefix(first_.data(), second_.data(), bytes) / size;
    first_.skip(equal * size);
    second_.skip(equal * size);
    return static_cast<std::uint32_t>(equal);
  }

  bool element(const Field& field, const std::string& where) {
    if (field.kind == Kind::string) return compare_strings(field, where);
    return std::all_of(field.children.begin(), field.children.end(), [&](const Field& child) {
      return this->field(child, (where.empty() ? "" : where + ".") + name_of(child));
    });
  }

  static std::string name_of(const Field& field) {
    const std::string name = field.path.substr(field.path.rfind('.') + 1);
    return field.count == Field::Count::one ? name : name.substr(0, name.size() - 2);
  }

  bool compare_block(const Field& field, std::uint32_t count, const std::string& where) {
    const std::size_t size = *field.element * count;
    const Element first{first_.offset(), first_.data(), size}, second{second_.offset(), second_.data(), size};
    if (!first_.skip(count, *field.element) || !second_.skip(count, *field.element)) return false;
    const std::size_t at = common_prefix(first.bytes, second.bytes, size);
    if (at == size) return true;
    const std::size_t index = at / *field.element, start = index * *field.element;
    add({field.path, field.count == Field::Count::one ? where : fmt::format("{}[{}]", where, index),
         first.offset + at, second.offset + at, value_text(field.kind, first.bytes + start, *field.element),
         value_text(field.kind, second.bytes + start, *field.element)});
    return true;
  }

  bool compare_strings(const Field& field, const std::string& where) {
    const std::optional<Element> first = read_string(first_), second = read_string(second_);
    if (!first || !second) return false;
    const std::size_t at = common_prefix(first->bytes, second->bytes, std::min(first->size, second->size));
    if (at == first->size && at == second->size) return true;
    add({field.path, where, first->offset + at, second->offset + at,
         value_text(Kind::string, first->bytes, first->size),
         value_text(Kind::string, second->bytes, second->size)});
    return true;
  }

  static std::optional<Element> read_string(Cursor& cursor) {
    const std::optional<std::uint32_t> length = cursor.read_uint32();
    const Element element{cursor.offset(), cursor.data(), length.value_or(0)};
    if (!length || !cursor.skip(*length)) return std::nullopt;
    return element;
  }

  static bool pass_over(const Field& field, std::uint32_t count, Cursor& cursor) {
    if (field.element) return cursor.skip(count, *field.element);
    for (std::uint32_t i = 0; i < count; ++i) {
      if (field.kind == Kind::string ? !read_string(cursor) : !pass_over_children(field, cursor))
        return false;
    }
    return true;
  }

  static bool pass_over_children(const Field& field, Cursor& cursor) {
    return std::all_of(field.children.begin(), field.children.end(), [&](const Field& child) {
      std::optional<std::uint32_t> count = child.fixed_count;
      if (child.count == Field::Count::variable) count = cursor.read_uint32();
      return count && pass_over(child, *count, cursor);
    });
  }

  void compare_rest() {
    const std::size_t at =
        common_prefix(first_.data(), second_.data(), std::min(first_.left(), second_.left()));
    if (at == first_.left() && at == second_.left()) return;
    add({"", "", first_.offset() + at, second_.offset() + at,
         fmt::format("{} bytes left", first_.left() - at),
         fmt::format("{} bytes left", second_.left() - at)});
  }

  void add(FieldDifference difference) {
    if (fields_.insert(difference.field).second) found_.push_back(std::move(difference));
  }

  const Bytes& first_bytes_;
  const Bytes& second_bytes_;
  Cursor first_, second_;
  std::vector<FieldDifference> found_;
  std::set<std::string> fields_;
};

}  // namespace

std::vector<FieldDifference> field_differences(const Field& definition, const Bytes& first,
                                               const Bytes& second) {
  return Comparison(first, second).run(definition);
}

}  // namespace tzc::compare

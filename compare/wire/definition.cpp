// SPDX-License-Identifier: BSD-3-Clause
#include "wire/definition.h"

#include <charconv>
#include <map>
#include <sstream>

namespace tzc::compare {
namespace {

struct Builtin {
  Kind kind;
  std::optional<std::size_t> size;
};

const std::map<std::string, Builtin>& builtins() {
  static const std::map<std::string, Builtin> all = {
      {"bool", {Kind::boolean, 1}},     {"int8", {Kind::int8, 1}},      {"byte", {Kind::int8, 1}},
      {"uint8", {Kind::uint8, 1}},      {"char", {Kind::uint8, 1}},     {"int16", {Kind::int16, 2}},
      {"uint16", {Kind::uint16, 2}},    {"int32", {Kind::int32, 4}},    {"uint32", {Kind::uint32, 4}},
      {"int64", {Kind::int64, 8}},      {"uint64", {Kind::uint64, 8}},  {"float32", {Kind::float32, 4}},
      {"float64", {Kind::float64, 8}},  {"string", {Kind::string, {}}}, {"time", {Kind::time, 8}},
      {"duration", {Kind::duration, 8}}};
  return all;
}

struct Declaration {
  std::string type, name;
  Field::Count count = Field::Count::one;
  std::uint32_t fixed_count = 1;
};
using Section = std::vector<Declaration>;

/// "type", "type[]" or "type[3]". False: a bad number of elements.
bool read_type(const std::string& word, Declaration& declaration) {
  const std::size_t bracket = word.find('[');
  declaration.type = word.substr(0, bracket);
  if (bracket == std::string::npos) return true;
  const char* const first = word.data() + bracket + 1;
  const char* const last = word.data() + word.size() - 1;
  if (first > last || *last != ']') return false;
  declaration.count = first == last ? Field::Count::variable : Field::Count::fixed;
  return first == last || std::from_chars(first, last, declaration.fixed_count).ptr == last;
}

/// Adds what a line declares: nothing for comments and constants. False: the line is no declaration.
bool read_line(const std::string& line, Section& section) {
  std::istringstream words(line.substr(0, line.find('#')));
  std::string type, name, rest;
  if (!(words >> type)) return true;
  if (!(words >> name)) return false;
  if (name.find('=') != std::string::npos) return true;
  if (words >> rest && rest.front() == '=') return true;
  Declaration declaration;
  declaration.name = name;
  if (!rest.empty() || !read_type(type, declaration)) return false;
  section.push_back(declaration);
  return true;
}

class Expander {
 public:
  Expander(std::string datatype, const std::string& text) : root_(std::move(datatype)) {
    valid_ = read(text);
  }

  std::optional<Field> expand() {
    Field field;
    if (!valid_ || !fill(root_, field, 0)) return std::nullopt;
    return field;
  }

 private:
  static constexpr int deepest = 50;  ///< a type that contains itself ends here

  bool read(const std::string& text) {
    std::istringstream lines(text);
    std::string line, current = root_;
    while (std::getline(lines, line)) {
      if (!line.empty() && line.back() == '\r') line.pop_back();
      if (line.compare(0, 10, "==========") == 0) continue;
      if (line.compare(0, 5, "MSG: ") == 0) {
        current = line.substr(5, line.find_last_not_of(' ') - 4);
        continue;
      }
      if (!read_line(line, sections_[current])) return false;
    }
    sections_[root_];  // an empty message
    return true;
  }

  std::string resolve(const std::string& type, const std::string& user) const {
    if (type.find('/') != std::string::npos) return type;
    if (type == "Header") return "std_msgs/Header";
    return user.substr(0, user.find('/') + 1) + type;
  }

  /// Expands message type `type` into `field`, whose path is set already.
  bool fill(const std::string& type, Field& field, int depth) {
    const auto section = sections_.find(type);
    if (section == sections_.end() || depth > deepest) return false;
    const std::string prefix = field.path.empty() ? "" : field.path + ".";
    std::size_t size = 0;
    bool is_fixed = true;
    for (const Declaration& declaration : section->second) {
      Field child;
      child.path = prefix + declaration.name + (declaration.count == Field::Count::one ? "" : "[]");
      child.count = declaration.count;
      child.fixed_count = declaration.fixed_count;
      if (!fill_type(declaration.type, type, child, depth)) return false;
      is_fixed = is_fixed && child.element && child.count != Field::Count::variable;
      size += child.element.value_or(0) * child.fixed_count;
      field.children.push_back(std::move(child));
    }
    field.kind = Kind::message;
    if (is_fixed) field.element = size;
    field.is_header = type == "std_msgs/Header" && looks_like_header(section->second);
    return true;
  }

  bool fill_type(const std::string& type, const std::string& user, Field& field, int depth) {
    const auto builtin = builtins().find(type);
    if (builtin == builtins().end()) return fill(resolve(type, user), field, depth + 1);
    field.kind = builtin->second.kind;
    field.element = builtin->second.size;
    return true;
  }

  /// The fields that std_msgs/Header's md5sum stands for.
  static bool looks_like_header(const Section& section) {
    static const char* const fields[][2] = {{"uint32", "seq"}, {"time", "stamp"}, {"string", "frame_id"}};
    if (section.size() != 3) return false;
    for (std::size_t i = 0; i < 3; ++i) {
      if (section[i].type != fields[i][0] || section[i].name != fields[i][1]) return false;
      if (section[i].count != Field::Count::one) return false;
    }
    return true;
  }

  const std::string root_;
  std::map<std::string, Section> sections_;
  bool valid_ = false;
};

}  // namespace

std::optional<Field> parse_definition(const std::string& datatype, const std::string& text) {
  return Expander(datatype, text).expand();
}

}  // namespace tzc::compare

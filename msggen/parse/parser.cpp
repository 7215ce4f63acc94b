// SPDX-License-Identifier: BSD-3-Clause
#include "parse/parser.h"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

#include "parse/identifier.h"
#include "parse/text.h"
#include "parse/value.h"

namespace tzc::msggen {
namespace {

constexpr const char* header_type = "std_msgs/Header";
constexpr std::uint64_t largest_array = 0xFFFFFFFFu;

// Parses the lines of one message, one after the other.
class LineParser {
 public:
  LineParser(Message& message, Diagnostics& diagnostics) : message_(message), diagnostics_(diagnostics) {}

  void parse(const Line& line) {
    line_ = line;
    clean_ = without_comment(line.text);
    if (clean_.empty()) return;
    if (clean_.find('=') == std::string_view::npos) {
      parse_field();
    } else {
      parse_constant();
    }
  }

 private:
  void report(std::string_view piece, std::string message, std::string hint = {}) {
    Diagnostic d;
    d.file = message_.file;
    d.at = {line_.number, column_of(line_.text, piece)};
    d.width = character_count(piece);
    d.source_line = std::string(line_.text);
    d.message = std::move(message);
    d.hint = std::move(hint);
    diagnostics_.report(std::move(d));
  }

  // Fields and constants share one scope, as they do in C++.
  bool declare(std::string_view name, const char* kind, const std::string& fault) {
    if (!fault.empty()) {
      const bool shifted = name.substr(0, 7) == "string ";
      report(name, fmt::format("the {}'s name '{}' {}", kind, name, fault),
             shifted
                 ? "genmsg takes all after the line's first blank as the name: begin the line with 'string'"
                 : "");
      return false;
    }
    auto [first, is_new] = names_.emplace(std::string(name), line_.number);
    if (!is_new)
      report(name, fmt::format("duplicate name '{}'", name), fmt::format("first in line {}", first->second));
    return is_new;
  }

  void parse_field() {
    const auto tokens = words(clean_);
    if (tokens.size() != 2) return report_field_shape(tokens);
    Field field;
    if (!parse_type(tokens[0], field) || !declare(tokens[1], "field", identifier_fault(tokens[1]))) return;
    field.name = std::string(tokens[1]);
    field.at = {line_.number, column_of(line_.text, tokens[0])};
    field.type_width = character_count(tokens[0]);
    field.source_line = std::string(line_.text);
    message_.fields.push_back(std::move(field));
  }

  void report_field_shape(const std::vector<std::string_view>& tokens) {
    if (tokens.size() > 2) {
      const bool brackets = tokens[0].find('[') != std::string_view::npos || tokens[1][0] == '[';
      return report(tokens[2], fmt::format("unexpected '{}' after the field's name", tokens[2]),
                    brackets ? "no blanks in array brackets" : "a comment begins with #");
    }
    const std::size_t tab = clean_.find('\t');
    if (tab != std::string_view::npos) {
      return report(clean_.substr(tab, 1), "a tab does not separate type and name",
                    "genmsg wants a blank there");
    }
    report(clean_, fmt::format("'{}' is not a field: a type and a name are expected", clean_));
  }

  // Type and array bounds: base, base[], base[n].
  bool parse_type(std::string_view text, Field& field) {
    const std::size_t bracket = std::min(text.find('['), text.size());
    const std::string_view base = text.substr(0, bracket), bounds = text.substr(bracket);
    if (!check_type_name(base) || !parse_bounds(bounds, field)) return false;
    field.builtin = find_builtin(base);
    field.base = std::string(base);
    // Only the plain word `Header` is special: `Header[]` is an array of this package's own Header.
    if (text == "Header") {
      field.base = header_type;
    } else if (!field.builtin && base.find('/') == std::string_view::npos) {
      field.base = message_.package + "/" + field.base;
    }
    field.type = field.base + std::string(bounds);
    return true;
  }

  bool check_type_name(std::string_view base) {
    const std::size_t slash = base.find('/');
    const std::string_view package = slash == std::string_view::npos ? base : base.substr(0, slash);
    const std::string_view name = slash == std::string_view::npos ? base : base.substr(slash + 1);
    if (slash == std::string_view::npos && find_builtin(base)) return true;
    if (package.empty() || name.empty()) {
      report(base, fmt::format("'{}' is not the name of a type", base),
             "a type is written as Name or package/Name");
      return false;
    }
    for (std::string_view part : {package, name}) {
      if (std::string fault = identifier_fault(part); !fault.empty()) {
        report(part, fmt::format("the type's name '{}' {}", part, fault),
               slash == std::string_view::npos ? "" : "a type is written as Name or package/Name");
        return false;
      }
    }
    return true;
  }

  bool parse_bounds(std::string_view bounds, Field& field) {
    if (bounds.empty()) return true;
    field.array = bounds == "[]" ? ArrayKind::variable : ArrayKind::fixed;
    if (bounds == "[]") return true;
    const std::string_view digits = bounds.substr(1, bounds.size() < 2 ? 0 : bounds.size() - 2);
    const bool is_number =
        !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    if (bounds.back() != ']' || !is_number) {
      report(bounds, fmt::format("'{}' are no array bounds", bounds), bounds_hint(bounds));
      return false;
    }
    for (char digit : digits) {
      field.length = std::min(field.length * 10 + static_cast<std::uint64_t>(digit - '0'), largest_array + 1);
    }
    if (field.length > largest_array) {
      report(bounds, fmt::format("an array of {} elements is too long", digits),
             "a ROS message is shorter than 4 GiB; a variable-length array is written []");
      return false;
    }
    return true;
  }

  static const char* bounds_hint(std::string_view bounds) {
    if (bounds.find('[', 1) != std::string_view::npos)
      return "arrays have one dimension: nest a message instead";
    if (bounds.back() != ']') return "a bracket is not closed";
    return "write [] or [3]";
  }

  void parse_constant() {
    const std::string_view type_name = words(clean_).front();
    const Builtin* type = find_builtin(type_name);
    if (!type || !type->may_be_constant()) {
      const bool known = type != nullptr;
      return report(type_name, fmt::format("'{}' cannot be the type of a constant", type_name),
                    known ? "constants of time and duration do not exist" : "numbers, bool and string can");
    }
    if (type->kind == BuiltinKind::string) {
      const std::size_t equals = line_.text.find('=');
      const std::size_t name_start = line_.text.find(' ') + 1;
      return add_constant(*type, line_.text.substr(name_start, equals - std::min(equals, name_start)),
                          line_.text.substr(equals + 1));
    }
    const std::string_view rest = clean_.substr(static_cast<std::size_t>(type_name.end() - clean_.begin()));
    const std::size_t equals = rest.find('=');
    if (const std::size_t second = rest.find('=', equals + 1); second != std::string_view::npos) {
      return report(rest.substr(second, 1), "a second '=' in a constant",
                    "only string constants may contain it");
    }
    add_constant(*type, rest.substr(0, equals), rest.substr(equals + 1));
  }

  void add_constant(const Builtin& type, std::string_view name, std::string_view text) {
    name = strip(name);
    text = strip(text);
    if (name.empty()) return report(clean_, "the constant has no name");
    if (!declare(name, "constant", constant_name_fault(name))) return;
    if (text.empty() && type.kind != BuiltinKind::string) return report(clean_, "the constant has no value");
    Value value = convert_value(type, text);
    if (!value.error.empty()) return report(text, value.error, value.hint);
    message_.constants.push_back({std::string(type.name), std::string(name), std::string(text), value.text});
  }

  Message& message_;
  Diagnostics& diagnostics_;
  Line line_;
  std::string_view clean_;
  std::unordered_map<std::string, std::size_t> names_;
};

}  // namespace

Message parse_message(const Section& section, const std::string& file, const std::string& package,
                      const std::string& name, Diagnostics& diagnostics) {
  Message message;
  message.package = package;
  message.name = name;
  message.file = file;
  message.text = section.text;
  LineParser parser(message, diagnostics);
  for (const Line& line : section.lines) parser.parse(line);
  return message;
}

}  // namespace tzc::msggen

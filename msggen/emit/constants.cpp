// SPDX-License-Identifier: BSD-3-Clause
#include "emit/constants.h"

#include <fmt/format.h>

#include "model/builtin.h"

namespace tzc::msggen {
namespace {

bool is_integer(const Constant& c) {
  return find_builtin(c.type)->kind == BuiltinKind::integer;
}

// -9223372036854775808 is no literal: the minus is applied to a number that is too large.
std::string integer_literal(const Constant& c) {
  const Builtin& type = *find_builtin(c.type);
  if (c.value == "-9223372036854775808") return "-9223372036854775807 - 1";
  return c.value + (type.is_signed || type.name == "char" ? "" : "u");
}

// Octal escapes end after three digits, whatever follows; a '?' is escaped because of trigraphs.
std::string string_literal(const std::string& text) {
  std::string result = "\"";
  for (char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\' || c == '?') {
      result += '\\';
      result += c;
    } else if (byte < 0x20 || byte == 0x7F) {
      result += fmt::format("\\{:03o}", byte);
    } else {
      result += c;
    }
  }
  return result + "\"";
}

std::string literal(const Constant& c) {
  if (c.type == "string") return string_literal(c.value);
  const std::string cpp(find_builtin(c.type)->cpp);
  if (c.value == "nan") return fmt::format("::std::numeric_limits<{}>::quiet_NaN()", cpp);
  if (c.value == "inf") return fmt::format("::std::numeric_limits<{}>::infinity()", cpp);
  if (c.value == "-inf") return fmt::format("-::std::numeric_limits<{}>::infinity()", cpp);
  return c.value;
}

std::string declaration(const Constant& c) {
  return fmt::format("  static const {} {};\n", find_builtin(c.type)->cpp, c.name);
}

}  // namespace

std::string integer_constants(const Message& message) {
  std::string text;
  for (const Constant& c : message.constants) {
    if (is_integer(c)) text += fmt::format("    {} = {},\n", c.name, integer_literal(c));
  }
  return text.empty() ? "" : "\n  enum {\n" + text + "  };\n";
}

OutOfLineConstants out_of_line_constants(const Message& message) {
  const std::string base = message.name + "Constants_";
  std::string declarations, definitions;
  for (const Constant& c : message.constants) {
    if (is_integer(c)) continue;
    declarations += declaration(c);
    definitions += fmt::format("template <class Unused>\nconst {} {}<Unused>::{} = {};\n",
                               find_builtin(c.type)->cpp, base, c.name, literal(c));
  }
  if (declarations.empty()) return {};
  return {base + "<void>", fmt::format("template <class Unused>\nstruct {} {{\n{}}};\n\n{}\n", base,
                                       declarations, definitions)};
}

}  // namespace tzc::msggen

// SPDX-License-Identifier: BSD-3-Clause
#include "parse/identifier.h"

#include <algorithm>

#include "parse/text.h"

namespace tzc::msggen {
namespace {

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

// C++14's; what later standards added may be a name in the messages of a package that builds as C++14.
constexpr std::string_view keywords[] = {
    "alignas",   "alignof",  "and",      "and_eq",    "asm",          "auto",          "bitand",
    "bitor",     "bool",     "break",    "case",      "catch",        "char",          "char16_t",
    "char32_t",  "class",    "compl",    "const",     "const_cast",   "constexpr",     "continue",
    "decltype",  "default",  "delete",   "do",        "double",       "dynamic_cast",  "else",
    "enum",      "explicit", "export",   "extern",    "false",        "float",         "for",
    "friend",    "goto",     "if",       "inline",    "int",          "long",          "mutable",
    "namespace", "new",      "noexcept", "not",       "not_eq",       "nullptr",       "operator",
    "or",        "or_eq",    "private",  "protected", "public",       "register",      "reinterpret_cast",
    "return",    "short",    "signed",   "sizeof",    "static",       "static_assert", "static_cast",
    "struct",    "switch",   "template", "this",      "thread_local", "throw",         "true",
    "try",       "typedef",  "typeid",   "typename",  "union",        "unsigned",      "using",
    "virtual",   "void",     "volatile", "wchar_t",   "while",        "xor",           "xor_eq"};

}  // namespace

std::string constant_name_fault(std::string_view name) {
  const std::size_t underscores = std::min(name.find_first_not_of('_'), name.size());
  if (underscores == 0) return identifier_fault(name);
  const std::string rest = "x" + std::string(name.substr(underscores));
  return identifier_fault(rest);
}

std::string identifier_fault(std::string_view name) {
  if (name.empty()) return "is empty";
  if (!is_letter(name.front())) return "does not begin with a letter";
  auto bad = std::find_if(name.begin(), name.end(),
                          [](char c) { return !is_letter(c) && !is_digit(c) && c != '_'; });
  if (bad != name.end()) return "may contain letters, digits and underscores only";
  if (std::find(std::begin(keywords), std::end(keywords), name) != std::end(keywords))
    return "is a C++ keyword";
  return {};
}

}  // namespace tzc::msggen

// SPDX-License-Identifier: BSD-3-Clause
#include "parse/value.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <optional>

#include "parse/text.h"

namespace tzc::msggen {
namespace {

// Digits with single underscores between them, as Python allows; without the underscores.
std::optional<std::string> plain_digits(std::string_view text) {
  std::string digits;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '_' && i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]))
      continue;
    if (!is_digit(text[i])) return std::nullopt;
    digits += text[i];
  }
  return digits.empty() ? std::nullopt : std::optional<std::string>(digits);
}

struct Sign {
  bool negative = false;
  std::string_view rest;
};

Sign take_sign(std::string_view text) {
  if (text.empty() || (text[0] != '-' && text[0] != '+')) return {false, text};
  return {text[0] == '-', text.substr(1)};
}

std::string without_leading_zeros(const std::string& digits) {
  const std::size_t first = digits.find_first_not_of('0');
  return first == std::string::npos ? "0" : digits.substr(first);
}

bool longer_or_greater(const std::string& a, const std::string& b) {
  return a.size() != b.size() ? a.size() > b.size() : a > b;
}

std::uint64_t largest_magnitude(const Builtin& type, bool negative) {
  const unsigned bits = static_cast<unsigned>(type.size) * 8;
  if (!type.is_signed) return negative ? 0 : ~std::uint64_t{0} >> (64 - bits);
  const std::uint64_t half = std::uint64_t{1} << (bits - 1);
  return negative ? half : half - 1;
}

Value integer_error(const Builtin& type, std::string_view text) {
  const bool hexadecimal =
      text.size() > 1 && text[0] == '0' && std::isalpha(static_cast<unsigned char>(text[1]));
  return {"", fmt::format("'{}' is not a value for {}", text, type.name),
          hexadecimal ? "constants are written in decimal" : "an integer is expected"};
}

Value convert_integer(const Builtin& type, std::string_view text) {
  const Sign sign = take_sign(text);
  const auto digits = plain_digits(sign.rest);
  if (!digits) return integer_error(type, text);
  const std::string magnitude = without_leading_zeros(*digits);
  if (longer_or_greater(magnitude, std::to_string(largest_magnitude(type, sign.negative)))) {
    const std::string low = type.is_signed ? fmt::format("-{}", largest_magnitude(type, true)) : "0";
    return {"", fmt::format("{} does not fit into {}", text, type.name),
            fmt::format("its range is {} to {}", low, largest_magnitude(type, false))};
  }
  return {(sign.negative && magnitude != "0" ? "-" : "") + magnitude, "", ""};
}

// [digits][.digits][e[sign]digits], with at least one digit before the exponent.
bool is_decimal_number(std::string_view text) {
  std::size_t i = 0, before = 0;
  auto skip_digits = [&] {
    std::size_t start = i;
    while (i < text.size() && is_digit(text[i])) ++i;
    return i - start;
  };
  before = skip_digits();
  if (i < text.size() && text[i] == '.') {
    ++i;
    before += skip_digits();
  }
  if (before == 0) return false;
  if (i < text.size() && (text[i] == 'e' || text[i] == 'E')) {
    ++i;
    if (i < text.size() && (text[i] == '+' || text[i] == '-')) ++i;
    if (skip_digits() == 0) return false;
  }
  return i == text.size();
}

// Without underscores that stand between digits; any other stays and is found to be wrong.
std::string without_digit_separators(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '_' && i > 0 && i + 1 < text.size() && is_digit(text[i - 1]) && is_digit(text[i + 1]))
      continue;
    result += static_cast<char>(std::tolower(static_cast<unsigned char>(text[i])));
  }
  return result;
}

// What the digits of a Python literal with this prefix may be; empty: it is no prefix.
std::string_view digits_after(std::string_view prefix) {
  if (prefix == "0x" || prefix == "0X") return "0123456789abcdefABCDEF";
  if (prefix == "0o" || prefix == "0O") return "01234567";
  if (prefix == "0b" || prefix == "0B") return "01";
  return {};
}

// Digits with single underscores between them (and after a prefix, before the first); without the underscores.
std::string without_underscores(std::string_view text, bool after_prefix) {
  std::string digits;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool has_digit_before = i > 0 ? text[i - 1] != '_' : after_prefix;
    const bool separates = text[i] == '_' && has_digit_before && i + 1 < text.size();
    if (!separates) digits += text[i];
  }
  return digits;
}

// The digits of a Python integer without a sign. A decimal one does not begin with a zero, unless all of it is zero.
std::optional<std::string> python_digits(std::string_view text) {
  const std::string_view allowed = digits_after(text.substr(0, 2));
  const bool is_decimal = allowed.empty();
  const std::string digits = without_underscores(is_decimal ? text : text.substr(2), !is_decimal);
  if (digits.empty() || digits.find_first_not_of(is_decimal ? "0123456789" : allowed) != std::string::npos)
    return std::nullopt;
  if (is_decimal && digits.front() == '0' && without_leading_zeros(digits) != "0") return std::nullopt;
  return digits;
}

// genmsg evaluates the text as Python. Of all that Python takes, literals are taken here: True, False and numbers.
Value convert_boolean(std::string_view text) {
  if (text == "True") return {"1", "", ""};
  if (text == "False") return {"0", "", ""};
  const std::string_view magnitude = take_sign(text).rest;
  if (const auto digits = python_digits(magnitude))
    return {without_leading_zeros(*digits) == "0" ? "0" : "1", "", ""};
  const std::string number = without_digit_separators(magnitude);
  if (is_decimal_number(number) && number.find_first_of(".e") != std::string::npos)
    return {std::strtod(number.c_str(), nullptr) == 0 ? "0" : "1", "", ""};
  return {"", fmt::format("'{}' is not a value for bool", text), "write True or False"};
}

std::string literal(double value) {
  if (std::isnan(value)) return "nan";
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  std::string text = fmt::format("{}", value);
  return text.find_first_of(".e") == std::string::npos ? text + ".0" : text;
}

Value convert_floating(const Builtin& type, std::string_view text) {
  const std::string number = without_digit_separators(text);
  const std::string_view magnitude = take_sign(number).rest;
  const bool special = magnitude == "inf" || magnitude == "infinity" || magnitude == "nan";
  if (!special && !is_decimal_number(magnitude)) {
    return {"", fmt::format("'{}' is not a value for {}", text, type.name), "a decimal number is expected"};
  }
  return {literal(std::strtod(number.c_str(), nullptr)), "", ""};
}

}  // namespace

Value convert_value(const Builtin& type, std::string_view text) {
  switch (type.kind) {
    case BuiltinKind::string:
      return {std::string(text), "", ""};
    case BuiltinKind::integer:
      return convert_integer(type, text);
    case BuiltinKind::boolean:
      return convert_boolean(text);
    case BuiltinKind::floating:
      return convert_floating(type, text);
    case BuiltinKind::time:
      break;
  }
  return {"", fmt::format("{} cannot be a constant", type.name), ""};
}

}  // namespace tzc::msggen

// SPDX-License-Identifier: BSD-3-Clause
#include "wire/value_text.h"

#include <fmt/format.h>

#include <cctype>
#include <cstring>

namespace tzc::compare {
namespace {

constexpr std::size_t longest_string = 60;

template <class T>
T read(const std::uint8_t* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

std::string quoted(const std::uint8_t* bytes, std::size_t size) {
  std::string text = "\"";
  for (std::size_t i = 0; i < size && i < longest_string; ++i) {
    const char c = static_cast<char>(bytes[i]);
    text += std::isprint(bytes[i]) && c != '"' && c != '\\' ? std::string(1, c)
                                                            : fmt::format("\\x{:02x}", bytes[i]);
  }
  return text + (size > longest_string ? "..." : "\"");
}

std::string seconds(std::int64_t whole, std::int64_t nanoseconds) {
  return nanoseconds < 0 ? fmt::format("{} s {} ns", whole, nanoseconds)
                         : fmt::format("{}.{:09}", whole, nanoseconds);
}

}  // namespace

std::string value_text(Kind kind, const std::uint8_t* bytes, std::size_t size) {
  switch (kind) {
    case Kind::boolean:
    case Kind::uint8:
      return fmt::format("{}", read<std::uint8_t>(bytes));
    case Kind::int8:
      return fmt::format("{}", read<std::int8_t>(bytes));
    case Kind::int16:
      return fmt::format("{}", read<std::int16_t>(bytes));
    case Kind::uint16:
      return fmt::format("{}", read<std::uint16_t>(bytes));
    case Kind::int32:
      return fmt::format("{}", read<std::int32_t>(bytes));
    case Kind::uint32:
      return fmt::format("{}", read<std::uint32_t>(bytes));
    case Kind::int64:
      return fmt::format("{}", read<std::int64_t>(bytes));
    case Kind::uint64:
      return fmt::format("{}", read<std::uint64_t>(bytes));
    case Kind::float32:
      return fmt::format("{}", read<float>(bytes));
    case Kind::float64:
      return fmt::format("{}", read<double>(bytes));
    case Kind::time:
      return seconds(read<std::uint32_t>(bytes), read<std::uint32_t>(bytes + 4));
    case Kind::duration:
      return seconds(read<std::int32_t>(bytes), read<std::int32_t>(bytes + 4));
    case Kind::string:
      return quoted(bytes, size);
    case Kind::message:
      break;
  }
  return fmt::format("{} bytes", size);
}

}  // namespace tzc::compare

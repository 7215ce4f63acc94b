// SPDX-License-Identifier: BSD-3-Clause
#include "channel/connect/publisher_address.h"

#include <charconv>
#include <cstddef>
#include <utility>

namespace tzc {
namespace channel {
namespace {

constexpr char separator = '#';

bool parse_number(const char* begin, const char* end, std::uint64_t& number) {
  const auto parsed = std::from_chars(begin, end, number, 16);
  return parsed.ec == std::errc() && parsed.ptr == end && number != 0;
}

}  // namespace

std::string to_text(const PublisherAddress& address) {
  if (address.publication == 0) return address.socket;
  char digits[16];
  const auto written = std::to_chars(digits, digits + sizeof digits, address.publication, 16);
  return address.socket + separator + std::string(digits, written.ptr);
}

Expected<PublisherAddress> parse_publisher_address(const std::string& text) {
  const std::size_t end = text.find(separator);
  PublisherAddress address{text.substr(0, end), 0};
  if (end == std::string::npos ||
      parse_number(text.data() + end + 1, text.data() + text.size(), address.publication))
    return {std::move(address)};
  Error error;
  error.what = "use a publisher's address";
  error.where = text;
  error.hint = "after '#' it has the number of a publisher, as Publisher::address() gives it";
  return error;
}

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>

#include "tzc/error.h"

namespace tzc {
namespace channel {

/// Where a publisher is reached: a listening socket, and which of the publishers behind it. As text the socket's address,
/// for a numbered publisher followed by '#' and the number in hexadecimal.
struct PublisherAddress {
  std::string socket;             ///< posix/address.h
  std::uint64_t publication = 0;  ///< 0: the socket's only publisher
};

std::string to_text(const PublisherAddress& address);
/// Error: what follows '#' is not a publisher's number.
Expected<PublisherAddress> parse_publisher_address(const std::string& text);

}  // namespace channel
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/socket.h>
#include <sys/un.h>

#include <string>

#include "tzc/error.h"

namespace tzc {
namespace posix {

/// A local socket's address: "@name" is Linux's abstract namespace (no file, gone with its socket), anything
/// else the pathname of a socket file.
struct SocketAddress {
  sockaddr_un raw{};
  socklen_t size = 0;
  bool abstract() const noexcept { return raw.sun_path[0] == '\0'; }
};

/// Error: empty or longer than the system takes (107 bytes).
Expected<SocketAddress> parse_address(const std::string& text);

/// A fresh address that cannot be guessed: abstract where the system has that, else a pathname in the user's
/// runtime or temporary folder.
std::string generate_address();

}  // namespace posix
}  // namespace tzc

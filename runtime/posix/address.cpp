// SPDX-License-Identifier: BSD-3-Clause
#include "posix/address.h"

#include <cstddef>
#include <cstdlib>
#include <cstring>

#include "posix/nonce.h"

namespace tzc {
namespace posix {

Expected<SocketAddress> parse_address(const std::string& text) {
  SocketAddress address;
  const bool abstract = !text.empty() && text[0] == '@';
  if (text.size() < (abstract ? 2 : 1) || text.size() >= sizeof address.raw.sun_path) {
    Error error;
    error.what = "use a socket address";
    error.where = text;
    error.hint = "an address has 1 to " + std::to_string(sizeof address.raw.sun_path - 1) + " bytes";
    return error;
  }
  address.raw.sun_family = AF_UNIX;
  std::memcpy(address.raw.sun_path, text.data(), text.size());
  if (abstract) address.raw.sun_path[0] = '\0';
  // An abstract name has no terminator: its length is the address's.
  address.size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + text.size() + (abstract ? 0 : 1));
  return address;
}

std::string generate_address() {
#ifdef TZC_PORTABLE
  for (const char* variable : {"XDG_RUNTIME_DIR", "TMPDIR"}) {
    const char* folder = std::getenv(variable);
    if (folder != nullptr && *folder == '/' && std::strlen(folder) < 60)
      return std::string(folder) + "/tzc-" + nonce();
  }
  return "/tmp/tzc-" + nonce();
#else
  return "@tzc-" + nonce();
#endif
}

}  // namespace posix
}  // namespace tzc

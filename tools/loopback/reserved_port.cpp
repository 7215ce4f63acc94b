// SPDX-License-Identifier: BSD-3-Clause
#include "loopback/reserved_port.h"

#include <arpa/inet.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <random>
#include <system_error>

namespace tzc::loopback {
namespace {

constexpr int first_port = 15'000, ports = 17'000, attempts = 1000;

sockaddr_in address_of(int port) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  return address;
}

int new_socket() {
  return ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
}

template <class Call>  // bind or connect
bool succeeds(Call call, int socket, int port) {
  const sockaddr_in address = address_of(port);
  return call(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
}

}  // namespace

ReservedPort::ReservedPort() {
  std::random_device dice;
  for (int i = 0; i < attempts; ++i)
    if (reserve(first_port + static_cast<int>(dice() % ports))) return;
  throw std::system_error(errno, std::generic_category(), "no free port on the loopback interface");
}

ReservedPort::~ReservedPort() {
  ::close(socket_);
}

bool ReservedPort::reserve(int number) {
  const int socket = new_socket();
  if (socket < 0) throw std::system_error(errno, std::generic_category(), "no socket");
  if (!succeeds(::bind, socket, number)) {
    const int reason = errno;
    ::close(socket);
    errno = reason;
    return false;
  }
  // Only now: with it, bind would succeed beside another reservation.
  const int yes = 1;
  ::setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  socket_ = socket;
  number_ = number;
  return true;
}

bool is_listened_on(int port) {
  const int socket = new_socket();
  const bool connected = succeeds(::connect, socket, port);
  ::close(socket);
  return connected;
}

}  // namespace tzc::loopback

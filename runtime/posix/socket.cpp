// SPDX-License-Identifier: BSD-3-Clause
#include "posix/socket.h"

#include <fcntl.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

#include "posix/address.h"
#include "posix/descriptor_use.h"
#include "posix/error.h"
#include "posix/fork_epoch.h"

namespace tzc {
namespace posix {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int backlog = 128;

FileDescriptor open_socket() {
  return FileDescriptor(::socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0));
}

bool bind_to(int socket, const SocketAddress& address) {
  return ::bind(socket, reinterpret_cast<const sockaddr*>(&address.raw), address.size) == 0;
}

bool connect_once(int socket, const SocketAddress& address) {
  return ::connect(socket, reinterpret_cast<const sockaddr*>(&address.raw), address.size) == 0;
}

// Only a refused connection proves that a socket file is a leftover; anything else may be alive.
bool is_dead(const SocketAddress& address) {
  const FileDescriptor probe = open_socket();
  return probe && !connect_once(probe.get(), address) && errno == ECONNREFUSED;
}

bool bind_replacing_leftover(int socket, const SocketAddress& address) {
  if (bind_to(socket, address)) return true;
  if (errno != EADDRINUSE || address.abstract()) return false;
  if (is_dead(address) && ::unlink(address.raw.sun_path) == 0) return bind_to(socket, address);
  errno = EADDRINUSE;
  return false;
}

}  // namespace

Listener::Listener(Listener&& other) noexcept
    : descriptor_(std::move(other.descriptor_)), address_(std::move(other.address_)), epoch_(other.epoch_) {
  other.address_.clear();
}

Listener& Listener::operator=(Listener&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  std::swap(address_, other.address_);
  std::swap(epoch_, other.epoch_);
  return *this;
}

Listener::~Listener() {
  const bool has_file = descriptor_ && !address_.empty() && address_[0] != '@';
  if (has_file && !forked_since(epoch_)) ::unlink(address_.c_str());
}

Expected<Listener> Listener::listen(const std::string& text) {
  const Expected<SocketAddress> address = parse_address(text);
  if (!address) return address.error();
  Listener listener;
  listener.descriptor_ = open_socket();
  if (!listener.descriptor_) return system_error("open a socket", text);
  if (!bind_replacing_leftover(listener.fd(), *address)) return system_error("bind a socket", text);
  listener.address_ = text;
  listener.epoch_ = fork_epoch();
  if (::listen(listener.fd(), backlog) != 0) return system_error("listen", text);
  return {std::move(listener)};
}

AcceptResult accept_connection(int listener, FileDescriptor& connection) noexcept {
  connection = FileDescriptor(::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC | SOCK_NONBLOCK));
  if (connection) return AcceptResult::accepted;
  const bool exhausted = errno == EMFILE || errno == ENFILE || errno == ENOBUFS || errno == ENOMEM;
  return exhausted ? AcceptResult::exhausted : AcceptResult::nothing;
}

Expected<FileDescriptor> connect_to(const std::string& text, std::chrono::milliseconds timeout) {
  const Expected<SocketAddress> address = parse_address(text);
  if (!address) return address.error();
  FileDescriptor socket = open_socket();
  if (!socket) return system_error("open a socket", text);
  const Clock::time_point deadline = Clock::now() + timeout;
  while (!connect_once(socket.get(), *address)) {
    const bool queue_full = errno == EAGAIN || errno == EINTR;
    if (!queue_full || Clock::now() >= deadline) return system_error("connect", text);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));  // a full backlog cannot be polled
  }
  ::fcntl(socket.get(), F_SETFL, 0);
  return {std::move(socket)};
}

SocketPair make_brief_socket_pair() noexcept {
  SocketPair pair;
  int ends[2] = {-1, -1};
  if (::socketpair(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC | SOCK_NONBLOCK, 0, ends) != 0) return pair;
  pair.ours = FileDescriptor(ends[0]);
  pair.theirs = FileDescriptor(ends[1]);
  return pair;
}

SocketPair make_socket_pair() noexcept {
  SocketPair pair = make_brief_socket_pair();
  if (pair.theirs && leaves_enough(pair.theirs.get())) return pair;
  return {};
}

bool wait_readable(int socket, std::chrono::milliseconds timeout) noexcept {
  const Clock::time_point deadline = Clock::now() + timeout;
  for (;;) {
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(deadline - Clock::now()).count();
    pollfd one{socket, POLLIN, 0};
    const int ready = ::poll(&one, 1, left > 0 ? static_cast<int>(left) : 0);
    if (ready > 0) return true;
    if (left <= 0 || (ready < 0 && errno != EINTR)) return false;
  }
}

Expected<channel::Credentials> peer_credentials(int socket) {
  ucred raw{};
  socklen_t size = sizeof raw;
  if (::getsockopt(socket, SOL_SOCKET, SO_PEERCRED, &raw, &size) != 0)
    return system_error("ask who the peer is");
  channel::Credentials credentials;
  credentials.pid = raw.pid;
  credentials.uid = raw.uid;
  credentials.gid = raw.gid;
  return credentials;
}

void stop_receiving(int socket) noexcept {
  ::shutdown(socket, SHUT_RD);
}
void stop_sending(int socket) noexcept {
  ::shutdown(socket, SHUT_WR);
}
void disconnect(int socket) noexcept {
  ::shutdown(socket, SHUT_RDWR);
}

#ifndef TZC_PORTABLE
void remove_dead_sockets() {}
#endif

}  // namespace posix
}  // namespace tzc

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <string>

#include "posix/file_descriptor.h"
#include "tzc/credentials.h"
#include "tzc/error.h"

namespace tzc {
namespace posix {

/// A listening seqpacket socket; its socket file, if it has one, goes with it.
class Listener {
 public:
  Listener() noexcept = default;
  Listener(Listener&& other) noexcept;
  Listener& operator=(Listener&& other) noexcept;
  ~Listener();

  /// Replaces a leftover socket file that no process listens on. Errors: in use, not permitted, no descriptor.
  static Expected<Listener> listen(const std::string& address);

  int fd() const noexcept { return descriptor_.get(); }
  const std::string& address() const noexcept { return address_; }

 private:
  FileDescriptor descriptor_;
  std::string address_;
  std::uint32_t epoch_ = 0;
};

/// The result does not block.
enum class AcceptResult { accepted, nothing, exhausted /* no descriptor left: try again later */ };

/// Never blocks.
AcceptResult accept_connection(int listener, FileDescriptor& connection) noexcept;

/// Connects within the time given, also when the listener's queue is full for a while. The result blocks.
Expected<FileDescriptor> connect_to(const std::string& address, std::chrono::milliseconds timeout);

/// Two sockets, connected to each other. Neither blocks. Empty: no descriptor is left, or so few that this process needs
/// them for something else.
struct SocketPair {
  FileDescriptor ours, theirs;
};
SocketPair make_socket_pair() noexcept;
/// The same for a moment, so that nothing need be left for others. Empty: no descriptor is left.
SocketPair make_brief_socket_pair() noexcept;

/// Waits until the socket is readable; false when the time passed first.
bool wait_readable(int socket, std::chrono::milliseconds timeout) noexcept;

/// The process at the other end, as the kernel recorded it. Error: not a local socket.
Expected<channel::Credentials> peer_credentials(int socket);

/// Stops this end from receiving: a reader blocked on it returns, the peer's writes fail. The socket stays
/// open.
void stop_receiving(int socket) noexcept;
/// Tells the peer that nothing more comes. The socket stays open.
void stop_sending(int socket) noexcept;
/// Both: the peer sees a hang-up, and so does a poller that watches this end. The descriptor stays open.
void disconnect(int socket) noexcept;

/// Deletes the socket files that killed processes left behind in the folder of generated addresses. Does
/// nothing where addresses have no file.
void remove_dead_sockets();

}  // namespace posix
}  // namespace tzc

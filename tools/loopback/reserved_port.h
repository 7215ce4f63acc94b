// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace tzc::loopback {

/// A TCP port of 127.0.0.1 that no other ReservedPort has while this one lives: bound, and never listened on, so that
/// nobody gets it in the seconds before a server that was told its number listens. The server has to set SO_REUSEADDR
/// before it binds, as a ROS master does (Python's xmlrpc.server). Not thread-safe.
class ReservedPort {
 public:
  /// Below the ports that the system gives to outgoing connections. @throws std::system_error when no port or no descriptor is free
  ReservedPort();
  ~ReservedPort();
  ReservedPort(const ReservedPort&) = delete;
  ReservedPort& operator=(const ReservedPort&) = delete;

  int number() const { return number_; }

 private:
  bool reserve(int number);

  int socket_ = -1;
  int number_ = 0;
};

/// Whether something listens on the port of 127.0.0.1.
bool is_listened_on(int port);

}  // namespace tzc::loopback

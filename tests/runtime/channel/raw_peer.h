// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "channel/connect/publisher_address.h"
#include "channel/wire/wire.h"
#include "posix/packet.h"
#include "posix/socket.h"
#include "support.h"

namespace tzc {
namespace channel {
namespace test {

using std::chrono::milliseconds;

/// With which the publisher at this address is greeted.
inline Hello hello_to(const std::string& address, std::uint32_t features = 0) {
  Hello hello{PacketKind::hello, wire_magic, wire_version, 0, features};
  hello.publication = parse_publisher_address(address)->publication;
  return hello;
}

/// One end of a connection or trunk, whose packets the test writes and reads itself.
class RawPeer {
 public:
  explicit RawPeer(posix::FileDescriptor socket) : socket_(std::move(socket)), memory_(max_packet_bytes) {}
  static RawPeer connect(const std::string& address) {
    return RawPeer(*posix::connect_to(parse_publisher_address(address)->socket, milliseconds(60000)));
  }

  void send(const void* data, std::size_t size, std::vector<int> descriptors = {}) const {
    const iovec part{const_cast<void*>(data), size};
    posix::send_packet(socket_.get(), &part, 1, descriptors.data(), descriptors.size());
  }
  template <class Packet>
  void send(const Packet& packet, std::vector<int> descriptors = {}) const {
    send(&packet, sizeof packet, std::move(descriptors));
  }

  posix::ReceiveResult receive() {
    packet = posix::ReceivedPacket();
    posix::wait_readable(socket_.get(), milliseconds(60000));
    return posix::receive_packet(socket_.get(), memory_.data(), memory_.size(),
                                 posix::Waiting::return_at_once, true, packet);
  }
  bool is_readable_within(milliseconds time) const { return posix::wait_readable(socket_.get(), time); }
  PacketKind kind() const { return *reinterpret_cast<const PacketKind*>(memory_.data()); }
  template <class Packet>
  Packet as() const {
    Packet copy{};
    std::memcpy(&copy, memory_.data(), sizeof copy);
    return copy;
  }
  std::string text(std::size_t after) const {
    return std::string(reinterpret_cast<const char*>(memory_.data()) + after, packet.size - after);
  }

  posix::ReceivedPacket packet;

 private:
  posix::FileDescriptor socket_;
  std::vector<std::uint8_t> memory_;
};

inline RawPeer accept_at(const posix::Listener& listener) {
  posix::wait_readable(listener.fd(), milliseconds(60000));
  posix::FileDescriptor socket;
  posix::accept_connection(listener.fd(), socket);
  return RawPeer(std::move(socket));
}

/// What a subscriber on the shared thread asks for after it has connected, once.
inline RawPeer accept_trunk_at(const posix::Listener& listener) {
  RawPeer trunk = accept_at(listener);
  trunk.receive();
  trunk.send(TrunkWelcome{PacketKind::trunk_welcome, wire_version, 1});
  return trunk;
}

}  // namespace test
}  // namespace channel
}  // namespace tzc
